#include "vulkan/pipelines/descriptors.h"

#include <algorithm>
#include <deque>
#include <map>
#include <utility>

#include "vulkan/device/executor_errors.h"
#include "vulkan/device/functions.h"
#include "vulkan/device/to_vk.h"

namespace weft::vk {
namespace {

// The writes of one descriptor set, and the infos to which the writes point. The infos are in deques, so that
// their addresses stay valid when more are added.
struct SetWrites {
    std::vector<VkWriteDescriptorSet> writes;
    std::deque<std::vector<VkDescriptorImageInfo>> images;
    std::deque<std::vector<VkDescriptorBufferInfo>> buffers;
    // The infos of the imports that have one buffer for each frame slot.
    std::vector<std::pair<VkDescriptorBufferInfo*, ResourceId>> slot_buffers;
};

std::vector<const UseDecl*> uses_of(const PassDecl& pass, const ShaderBinding& binding) {
    std::vector<const UseDecl*> uses;
    for (const UseDecl& use : pass.uses)
        if (use.binding == binding.binding) uses.push_back(&use);
    return uses;
}

Result<VkDescriptorImageInfo> image_info(DescriptorSources& sources, const UseDecl* use, uint32_t element,
                                         const ShaderBinding& binding) {
    VkDescriptorImageInfo info{};
    if (use != nullptr) {
        const std::vector<VkImageView>* table = sources.resources.textures(use->resource);
        Result<VkImageView> view =
            table != nullptr ? (*table)[std::min<size_t>(element, table->size() - 1)]
                             : sources.views.shader_view(*use, element, binding, sources.resources.frame());
        if (!view) return view.take_errors();
        info = {VK_NULL_HANDLE, *view, to_vk(use->state.layout)};
    } else {
        Result<VkDescriptorImageInfo> dummy = sources.dummies.image(binding);
        if (!dummy) return dummy.take_errors();
        info = *dummy;
    }
    if (binding.kind != BindingKind::sampled_image) return info;
    const bool integer = binding.numeric == NumericClass::sint || binding.numeric == NumericClass::uint;
    SamplerDecl decl = use != nullptr ? use->sampler : SamplerDecl{};
    if (use == nullptr) {
        decl.filter = decl.mip_filter = SamplerFilter::nearest;
        if (binding.shadow) decl.compare = CompareOp::greater_equal;
    }
    Result<VkSampler> sampler = sources.samplers.get(decl, integer);
    if (!sampler) return sampler.take_errors();
    info.sampler = *sampler;
    return info;
}

Result<VkDescriptorBufferInfo> buffer_info(DescriptorSources& sources, const UseDecl* use,
                                           const ShaderBinding& binding) {
    if (use != nullptr) {
        const ByteRange bytes = used_bytes(sources.plan.graph.resources[use->resource], *use);
        return VkDescriptorBufferInfo{sources.resources.buffer(use->resource), bytes.offset_bytes,
                                      bytes.size_bytes};
    }
    Result<VkBuffer> dummy = sources.dummies.buffer(binding.block_bytes);
    if (!dummy) return dummy.take_errors();
    return VkDescriptorBufferInfo{*dummy, 0, VK_WHOLE_SIZE};
}

Status add_binding(DescriptorSources& sources, const PassDecl& pass, const ShaderBinding& binding,
                   SetWrites& out) {
    const std::vector<const UseDecl*> uses = uses_of(pass, binding);
    const uint32_t count = descriptor_count(sources.plan.graph, pass, binding);
    // A use fills the whole array if it is the only use of the binding and either has `each` (a list of mips
    // or layers) or is a table of textures. If the array is longer than the list or the table, the last
    // element of the list or table is repeated.
    const bool fills_array = uses.size() == 1 && (uses[0]->each != EachPart::none ||
                                                  sources.resources.textures(uses[0]->resource) != nullptr);
    if (!uses.empty() && !fills_array && uses.size() != count)
        return pass_error(sources.plan, pass, "V413",
                          "binding \"" + binding.name + "\" has " + std::to_string(count) +
                              " elements, but the pass has " + std::to_string(uses.size()) +
                              " ports for them");
    VkWriteDescriptorSet write{VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET};
    write.dstBinding = binding.binding;
    write.descriptorCount = count;
    write.descriptorType = to_vk(binding.kind);
    const bool is_image =
        binding.kind == BindingKind::sampled_image || binding.kind == BindingKind::storage_image;
    if (is_image)
        out.images.emplace_back();
    else
        out.buffers.emplace_back();
    for (uint32_t i = 0; i < count; ++i) {
        const UseDecl* use = uses.empty() ? nullptr : fills_array ? uses[0] : uses[i];
        if (is_image) {
            Result<VkDescriptorImageInfo> info = image_info(sources, use, fills_array ? i : 0, binding);
            if (!info) return info.take_errors();
            out.images.back().push_back(*info);
        } else {
            Result<VkDescriptorBufferInfo> info = buffer_info(sources, use, binding);
            if (!info) return info.take_errors();
            out.buffers.back().push_back(*info);
        }
    }
    for (uint32_t i = 0; i < uses.size(); ++i)
        if (!is_image && sources.resources.has_slot_buffers(uses[i]->resource))
            out.slot_buffers.emplace_back(&out.buffers.back()[i], uses[i]->resource);
    if (is_image)
        write.pImageInfo = out.images.back().data();
    else
        write.pBufferInfo = out.buffers.back().data();
    out.writes.push_back(write);
    return Unit{};
}

Result<SlotSets> allocate_sets(Device& device, VkDescriptorPool pool, const FramePlan& plan,
                               const PassDecl& pass, const PassLayout& layout) {
    std::array<VkDescriptorSetLayout, kFramesInFlight> layouts;
    layouts.fill(layout.ports.get());
    VkDescriptorSetAllocateInfo info{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO};
    info.descriptorPool = pool;
    info.descriptorSetCount = kFramesInFlight;
    info.pSetLayouts = layouts.data();
    SlotSets sets{};
    const VkResult result = device.fn().vkAllocateDescriptorSets(device.handle(), &info, sets.data());
    if (result != VK_SUCCESS)
        return failed_pass_call(plan, pass, "V413", "allocating the descriptor sets", result);
    return sets;
}

}  // namespace

Result<DescriptorPoolHandle> make_descriptor_pool(Device& device, const ResolvedGraph& graph,
                                                  const std::vector<SetDemand>& demands) {
    std::map<VkDescriptorType, uint32_t> counts;
    uint32_t sets = 0;
    for (const SetDemand& demand : demands) {
        const uint32_t pass_sets = demand.ring_phases * demand.variants * kFramesInFlight;
        sets += pass_sets;
        for (const ShaderBinding& binding : demand.interface->bindings)
            if (binding.set == kPortSet)
                counts[to_vk(binding.kind)] += descriptor_count(graph, *demand.pass, binding) * pass_sets;
        if (params_in_buffer(*demand.interface)) counts[VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER] += pass_sets;
    }
    if (counts.empty()) return DescriptorPoolHandle{};
    std::vector<VkDescriptorPoolSize> sizes;
    for (const auto& [type, count] : counts) sizes.push_back({type, count});
    VkDescriptorPoolCreateInfo info{VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO};
    info.maxSets = sets;
    info.poolSizeCount = static_cast<uint32_t>(sizes.size());
    info.pPoolSizes = sizes.data();
    VkDescriptorPool pool = VK_NULL_HANDLE;
    const VkResult result = device.fn().vkCreateDescriptorPool(device.handle(), &info, nullptr, &pool);
    if (result != VK_SUCCESS) return failed_call("V413", "creating the descriptor pool", result);
    return DescriptorPoolHandle(device, pool);
}

Result<SlotSets> make_port_sets(Device& device, VkDescriptorPool pool, DescriptorSources sources,
                                Position position, const PassDecl& pass, const ShaderInterface& interface,
                                const PassLayout& layout) {
    if (!layout.has_ports()) return SlotSets{};
    SetWrites ports;
    for (const ShaderBinding& binding : interface.bindings) {
        if (binding.set != kPortSet) continue;
        Status added = add_binding(sources, pass, binding, ports);
        if (!added) return added.take_errors();
    }
    Result<SlotSets> sets = allocate_sets(device, pool, sources.plan, pass, layout);
    if (!sets) return sets;
    for (uint32_t slot = 0; slot < kFramesInFlight; ++slot) {
        for (const auto& [info, resource] : ports.slot_buffers)
            info->buffer = sources.resources.in_slot(slot).buffer(resource);
        std::vector<VkWriteDescriptorSet> writes = ports.writes;
        VkDescriptorBufferInfo params{};
        if (params_in_buffer(interface)) {
            params = sources.params.descriptor(position, slot);
            VkWriteDescriptorSet write{VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET};
            write.dstBinding = interface.params.binding;
            write.descriptorCount = 1;
            write.descriptorType = VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER;
            write.pBufferInfo = &params;
            writes.push_back(write);
        }
        for (VkWriteDescriptorSet& write : writes) write.dstSet = (*sets)[slot];
        device.fn().vkUpdateDescriptorSets(device.handle(), static_cast<uint32_t>(writes.size()),
                                           writes.data(), 0, nullptr);
    }
    return sets;
}

}  // namespace weft::vk
