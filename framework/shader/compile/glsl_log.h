// Purpose: glslang's log becomes diagnostics that name the file the fault is in, which may be an included
// one. Lines look like "ERROR: name:12: 'token' : message".
#pragma once

#include <string>

#include "shader/compile/shader_sources.h"
#include "weft/result.h"

namespace weft::shader {

// Faults that the log places nowhere belong to `main`. Never empty: a failure without a message is one too.
[[nodiscard]] Diagnostics parse_glsl_log(const std::string& log, const SourceReader& reader,
                                         const SourceText& main);

}  // namespace weft::shader
