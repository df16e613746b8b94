// Purpose: compiled programs on disk, by content. A manifest for each reference lists every place that
// compiling it looked at (found or not) with the hashes of the texts; when looking again gives the same, the
// words are stored under the hash of all contents. Anything missing, changed or damaged means "compile
// again".
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "shader/compile/shader_sources.h"
#include "weft/shader/compile_shader.h"

namespace weft::shader {

// Of everything that decides the words: compiler, reference, kind, and the texts that were read.
[[nodiscard]] uint64_t content_hash_of(const std::string& reference, ProgramKind kind,
                                       const SourceReader& reader);

// Reference, modules and content hash; the interface is left to reflection. The words are not validated yet.
// `reader`, a new one, has read what compiling would read when something is returned.
[[nodiscard]] std::optional<ShaderProgram> load_cached(const std::string& reference, ProgramKind kind,
                                                       const ShaderRoots& roots, SourceReader& reader);

void store_cached(const ShaderProgram& program, ProgramKind kind, const ShaderRoots& roots,
                  const SourceReader& reader);

}  // namespace weft::shader
