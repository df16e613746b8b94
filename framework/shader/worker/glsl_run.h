// Purpose: compiles the text of one stage to SPIR-V with glslang. A callback supplies included files, and no
// file is opened here. glslang does not limit memory or time: a few hundred bytes of macros can use
// gigabytes, and deep nesting can overflow the stack. Therefore the worker program (shader/worker) limits
// itself before it calls run_glslang(), and all other code uses glsl_compile.h. Binding numbers and missing
// locations are provisional until link_stages() assigns them. Errors are in `log`, in the format of glslang.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "weft/shader_interface.h"

namespace weft::shader {

struct IncludeRequest {
    std::string name;      // The file name between the quotes or angle brackets of the #include.
    std::string includer;  // Name of the file that contains the #include.
    size_t depth = 1;      // Nesting depth of the #include; 1 in the shader file itself.
    // True for #include "x", which is searched beside the including file first; false for <x>.
    bool beside = false;
};

struct IncludeAnswer {
    bool found = false;
    std::string name;  // Name that the compiler uses for the included file.
    std::string text;  // Text of the file, or the reason why it cannot be included.
};
using IncludeReader = std::function<IncludeAnswer(const IncludeRequest&)>;

struct GlslOutcome {
    bool good = false;
    std::vector<uint32_t> spirv;
    std::set<std::string> unplaced;  // Names of stage inputs and outputs whose declaration has no location.
    std::string log;                 // Log of glslang if the compilation failed.
};

[[nodiscard]] GlslOutcome run_glslang(ShaderStage stage, const std::string& name, const std::string& text,
                                      const IncludeReader& includes);

// Returns a text with the versions of glslang and of Weft's compiler options. Two builds with different texts
// may compile the same GLSL to different SPIR-V. The shader cache uses the text as part of its keys.
[[nodiscard]] std::string compiler_version();

}  // namespace weft::shader
