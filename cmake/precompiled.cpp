// An empty source: CMake compiles the precompiled headers as a part of a target, and a target needs a source.
