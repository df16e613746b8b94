// CMake compiles precompiled headers for a target, and a target needs a source.
