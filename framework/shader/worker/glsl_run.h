// Purpose: runs glslang on the text of one stage and returns SPIR-V. It opens no file; a callback supplies
// includes. glslang does not limit memory or time: a few hundred bytes of macros can use gigabytes, and deep
// nesting can overflow the stack. The worker program therefore runs it under limits (shader/worker); all
// other code calls glsl_compile.h. Binding numbers and free locations are provisional until link_stages().
// Errors: `log`, in glslang's format.
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
    std::string name;      // the text between the quotes
    std::string includer;  // the name of the including text
    size_t depth = 1;
    bool beside = false;  // true for "x", which may lie beside the including file; false for <x>
};

struct IncludeAnswer {
    bool found = false;
    std::string name;  // the name that the compiler uses for this text
    std::string text;  // the text, or the reason why it is unavailable
};
using IncludeReader = std::function<IncludeAnswer(const IncludeRequest&)>;

struct GlslOutcome {
    bool good = false;
    std::vector<uint32_t> spirv;
    std::set<std::string> unplaced;  // stage inputs and outputs without an explicit location
    std::string log;                 // glslang's log, when the compilation failed
};

[[nodiscard]] GlslOutcome run_glslang(ShaderStage stage, const std::string& name, const std::string& text,
                                      const IncludeReader& includes);

// Changes whenever the same text may compile to different SPIR-V.
[[nodiscard]] std::string compiler_version();

}  // namespace weft::shader
