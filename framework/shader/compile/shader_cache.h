// Purpose: stores compiled programs on disk, so that unchanged shaders are not compiled again. For each
// shader, a manifest lists all files that its compilation searched for (also those that do not exist), with
// hashes of their texts. If all of them are unchanged, the SPIR-V is loaded from a second file, whose name is
// the result of content_hash_of(). If anything is missing, changed or damaged, the shader is compiled again.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "shader/compile/shader_sources.h"
#include "weft/shader/compile_shader.h"

namespace weft::shader {

// Returns the hash of all inputs that determine the SPIR-V: the version of the compiler, the reference to the
// shader, the kind of program, and the texts that `reader` has read.
[[nodiscard]] uint64_t content_hash_of(const std::string& reference, ProgramKind kind,
                                       const SourceReader& reader);

// Loads a program from the cache; returns nullopt if the cache does not contain it. Only the reference, the
// modules and the content hash are set; the interface must be computed by reflection. The SPIR-V is not
// validated yet. `reader` must not have read any file before the call. If a program is returned, `reader` has
// read the same texts as a compilation would read.
[[nodiscard]] std::optional<ShaderProgram> load_cached(const std::string& reference, ProgramKind kind,
                                                       const ShaderRoots& roots, SourceReader& reader);

void store_cached(const ShaderProgram& program, ProgramKind kind, const ShaderRoots& roots,
                  const SourceReader& reader);

}  // namespace weft::shader
