// Purpose: a cache of compiled programs on disk, addressed by content. The manifest of a reference lists
// every place that its compilation examined (found or not), with hashes of the texts. If examining the places
// again gives the same result, the SPIR-V is loaded by the hash of all contents. Anything missing, changed or
// damaged leads to a new compilation.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "shader/compile/shader_sources.h"
#include "weft/shader/compile_shader.h"

namespace weft::shader {

// Hash of all inputs that determine the SPIR-V: compiler, reference, kind, and the texts that were read.
[[nodiscard]] uint64_t content_hash_of(const std::string& reference, ProgramKind kind,
                                       const SourceReader& reader);

// Fills reference, modules and content hash, but not the interface, which reflection computes. The SPIR-V is
// not validated yet. If a program is returned, `reader` (which must be new) has read the same texts as a
// compilation would.
[[nodiscard]] std::optional<ShaderProgram> load_cached(const std::string& reference, ProgramKind kind,
                                                       const ShaderRoots& roots, SourceReader& reader);

void store_cached(const ShaderProgram& program, ProgramKind kind, const ShaderRoots& roots,
                  const SourceReader& reader);

}  // namespace weft::shader
