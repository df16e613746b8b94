#include "vulkan/pipelines/pass_shaders.h"

#include <algorithm>

#include "vulkan/pipelines/lowered_views.h"
#include "vulkan/pipelines/opaque_uniforms.h"

namespace weft::vk {
namespace {

// Returns the number of a view in its list: 2 for "sun(2)", 0 for "camera".
uint32_t number_of(const std::string& view) {
    const size_t open = view.find('(');
    return open == std::string::npos ? 0 : static_cast<uint32_t>(std::stoul(view.substr(open + 1)));
}

// The key of the pass's program in the catalog of shaders_for(). Names of shaders contain no line breaks.
std::string key_of(const PassDecl& pass) {
    switch (pass.lowering) {
        case ViewLowering::multiview:
            return pass.shader + "\nmultiview " + std::to_string(pass.views.size());
        case ViewLowering::layer_output:
            return pass.shader + "\nlayers from " + std::to_string(number_of(pass.view));
        case ViewLowering::none:
            break;
    }
    return pass.shader;
}

// A module that cannot be rewritten for multiview (see can_select_view()) stays unchanged.
// make_plan_objects() reports an error for it.
ShaderProgram lowered(ShaderProgram program, const PassDecl& pass) {
    for (ShaderModule& module : program.modules) {
        if (pass.lowering == ViewLowering::multiview && can_select_view(module.spirv))
            module.spirv =
                with_multiview(module.spirv, module.stage, static_cast<uint32_t>(pass.views.size()));
        if (pass.lowering == ViewLowering::layer_output && module.stage == ShaderStage::vertex)
            module.spirv = with_layer_output(module.spirv, number_of(pass.view));
    }
    return program;
}

}  // namespace

const ShaderCatalog* shaders_for(const Device& device, const ExecutorInput& input, ShaderCatalog& changed) {
    const bool lowers = std::ranges::any_of(
        input.plan.graph.passes, [](const PassDecl& pass) { return pass.lowering != ViewLowering::none; });
    const bool changes = device.hides_uniforms() || lowers;
    if (!changes || input.shaders == nullptr) return input.shaders;
    for (const PassDecl& pass : input.plan.graph.passes) {
        const auto found = input.shaders->find(pass.shader);
        const std::string key = key_of(pass);
        if (found == input.shaders->end() || changed.contains(key)) continue;
        ShaderProgram program = lowered(found->second, pass);
        if (device.hides_uniforms()) program = with_opaque_uniforms(std::move(program));
        changed.emplace(key, std::move(program));
    }
    return &changed;
}

const ShaderProgram* program_of(const ShaderCatalog* shaders, const PassDecl& pass) {
    if (shaders == nullptr) return nullptr;
    const auto found = shaders->find(key_of(pass));
    return found != shaders->end() ? &found->second : nullptr;
}

}  // namespace weft::vk
