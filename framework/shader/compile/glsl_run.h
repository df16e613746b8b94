// Purpose: glslang, and nothing around it: one stage's text to SPIR-V. It opens no file; includes come from a
// callback. It trusts its input with memory and time: a few hundred bytes of macros can cost gigabytes, and
// deep nesting the stack. The worker program runs it under limits (shader/worker); glsl_compile.h is the way
// in for everybody else. Numbers of bindings and free locations are provisional until link_stages().
// Errors: `log`, in glslang's own form.
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
    std::string name;      // what stands between the quotes
    std::string includer;  // the name of the text that asks
    size_t depth = 1;
    bool beside = false;  // "x" may lie beside the file that asks, <x> not
};

struct IncludeAnswer {
    bool found = false;
    std::string name;  // what the compiler shall call it
    std::string text;  // or why it can't be had
};
using IncludeReader = std::function<IncludeAnswer(const IncludeRequest&)>;

struct GlslOutcome {
    bool good = false;
    std::vector<uint32_t> spirv;
    std::set<std::string> unplaced;  // stage inputs and outputs that state no location
    std::string log;                 // when it is not good
};

[[nodiscard]] GlslOutcome run_glslang(ShaderStage stage, const std::string& name, const std::string& text,
                                      const IncludeReader& includes);

// Changes whenever the same text may give other words.
[[nodiscard]] std::string compiler_version();

}  // namespace weft::shader
