#include "vulkan/pipelines/pass_layout.h"

#include <algorithm>
#include <vector>

#include "vulkan/device/executor_errors.h"
#include "vulkan/device/functions.h"
#include "vulkan/device/to_vk.h"

namespace weft::vk {
namespace {

std::vector<VkDescriptorSetLayoutBinding> port_bindings(const ResolvedGraph& graph, const PassDecl& pass,
                                                        const ShaderInterface& interface) {
    std::vector<VkDescriptorSetLayoutBinding> out;
    for (const ShaderBinding& binding : interface.bindings)
        if (binding.set == kPortSet)
            out.push_back({binding.binding, to_vk(binding.kind), descriptor_count(graph, pass, binding),
                           shader_stages_to_vk(binding.stages), nullptr});
    if (params_in_buffer(interface))
        out.push_back({interface.params.binding, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, 1,
                       shader_stages_to_vk(interface.params.stages), nullptr});
    return out;
}

VkResult make_set_layout(Device& device, const std::vector<VkDescriptorSetLayoutBinding>& bindings,
                         SetLayoutHandle& out) {
    VkDescriptorSetLayoutCreateInfo info{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO};
    info.bindingCount = static_cast<uint32_t>(bindings.size());
    info.pBindings = bindings.data();
    VkDescriptorSetLayout layout = VK_NULL_HANDLE;
    const VkResult result = device.fn().vkCreateDescriptorSetLayout(device.handle(), &info, nullptr, &layout);
    if (result == VK_SUCCESS) out = {device, layout};
    return result;
}

// Returns the layouts of all sets up to the highest one in use. Errors name the sets that the draw source
// does not have.
Result<std::vector<VkDescriptorSetLayout>> choose_sets(const FramePlan& plan, const PassDecl& pass,
                                                       const PassLayout& layout, const DrawSource* draws) {
    std::vector<VkDescriptorSetLayout> sets;
    Diagnostics errors;
    for (uint32_t set = 0; set < kSetCount; ++set) {
        if (!layout.declares[set]) continue;
        sets.resize(set + 1, layout.empty.get());
        sets[set] = set == kPortSet ? layout.ports.get() : draws ? draws->set_layout(set) : VK_NULL_HANDLE;
        if (sets[set] == VK_NULL_HANDLE)
            errors.push_back(pass_error(plan, pass, "V415",
                                        "shader \"" + pass.shader + "\" declares descriptor set " +
                                            std::to_string(set) +
                                            ", which the DrawSource of the program does not provide"));
    }
    if (!errors.empty()) return errors;
    return sets;
}

}  // namespace

uint32_t descriptor_count(const ResolvedGraph& graph, const PassDecl& pass, const ShaderBinding& binding) {
    if (!binding.is_runtime_array) return binding.count;
    for (const UseDecl& use : pass.uses)
        if (use.binding == binding.binding) return std::max(1u, graph.resources[use.resource].textures);
    return 1;
}

Result<PassLayout> make_pass_layout(Device& device, const FramePlan& plan, const PassDecl& pass,
                                    const ShaderInterface& interface, const DrawSource* draws) {
    PassLayout layout;
    const std::vector<VkDescriptorSetLayoutBinding> bindings = port_bindings(plan.graph, pass, interface);
    for (const ShaderBinding& binding : interface.bindings)
        if (binding.set < kSetCount) layout.declares[binding.set] = true;
    if (params_in_buffer(interface)) layout.declares[kPortSet] = true;
    VkResult result = make_set_layout(device, bindings, layout.ports);
    if (result == VK_SUCCESS) result = make_set_layout(device, {}, layout.empty);
    if (result != VK_SUCCESS)
        return failed_pass_call(plan, pass, "V413", "creating the descriptor set layouts", result);

    Result<std::vector<VkDescriptorSetLayout>> sets = choose_sets(plan, pass, layout, draws);
    if (!sets) return sets.take_errors();
    VkPipelineLayoutCreateInfo info{VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO};
    info.setLayoutCount = static_cast<uint32_t>(sets->size());
    info.pSetLayouts = sets->data();
    VkPushConstantRange push{};
    if (interface.has_params && interface.params.push_constants) {
        layout.push_stages = shader_stages_to_vk(interface.params.stages);
        push = {layout.push_stages, 0, interface.params.size_bytes};
    } else if (device.hides_uniforms()) {
        layout.index_stages = shader_stages_to_vk(interface.stages);
        push = {layout.index_stages, 0, sizeof(uint32_t)};
    }
    info.pushConstantRangeCount = push.size > 0 ? 1 : 0;
    info.pPushConstantRanges = &push;
    VkPipelineLayout object = VK_NULL_HANDLE;
    result = device.fn().vkCreatePipelineLayout(device.handle(), &info, nullptr, &object);
    if (result != VK_SUCCESS)
        return failed_pass_call(plan, pass, "V413", "creating the pipeline layout", result);
    layout.pipeline = {device, object};
    return layout;
}

}  // namespace weft::vk
