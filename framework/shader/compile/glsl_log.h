// Purpose: converts glslang's log to diagnostics that name the faulty file, which may be an included one. Log
// lines look like "ERROR: name:12: 'token' : message".
#pragma once

#include <string>

#include "shader/compile/shader_sources.h"
#include "weft/result.h"

namespace weft::shader {

// Faults without a place in the log are assigned to `main`. The result is never empty: a failed compilation
// without a message becomes a diagnostic too.
[[nodiscard]] Diagnostics parse_glsl_log(const std::string& log, const SourceReader& reader,
                                         const SourceText& main);

}  // namespace weft::shader
