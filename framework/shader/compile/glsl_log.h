// Purpose: converts the log of glslang to diagnostics. Each diagnostic names the file with the error, which
// may be an included file. Lines of the log look like "ERROR: name:12: 'token' : message".
#pragma once

#include <string>

#include "shader/compile/shader_sources.h"
#include "weft/result.h"

namespace weft::shader {

// Converts the log of a failed compilation. Errors without a file in the log are assigned to the file `main`.
// The result contains at least one diagnostic, even if the log contains no message.
[[nodiscard]] Diagnostics parse_glsl_log(const std::string& log, const SourceReader& reader,
                                         const SourceText& main);

}  // namespace weft::shader
