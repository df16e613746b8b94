// Purpose: one GLSL stage through glslang: text to SPIR-V, with includes read by a SourceReader. Numbers of
// bindings and free locations are provisional until link_stages() has dealt them out.
// Errors: W202 GLSL error, W203 include not found or outside the roots.
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "shader/shader_sources.h"
#include "weft/result.h"
#include "weft/shader_interface.h"

namespace weft::shader {

struct CompiledStage {
    ShaderStage stage = ShaderStage::compute;
    const SourceText* source = nullptr;
    std::vector<uint32_t> spirv;
    std::set<std::string> unplaced;  // stage inputs and outputs that state no location
};

[[nodiscard]] Result<CompiledStage> compile_stage(ShaderStage stage, const SourceText& source,
                                                  SourceReader& reader);

// Changes whenever the same text may give other words.
[[nodiscard]] std::string compiler_version();

}  // namespace weft::shader
