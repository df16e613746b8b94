// A target needs a source; what weft_precompiled_tests is for says WeftTarget.cmake.
