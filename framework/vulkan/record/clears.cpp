#include "vulkan/record/clears.h"

#include "graph/diagnostics/whole_number.h"
#include "vulkan/device/functions.h"
#include "vulkan/device/to_vk.h"
#include "vulkan/record/barriers_vk.h"
#include "vulkan/record/rendering_scope.h"

namespace weft::vk {

void record_clear_of(const Device& device, VkCommandBuffer commands, const FramePlan& plan,
                     const FrameResources& resources, const ClearTarget& target) {
    const DeviceFunctions& fn = device.fn();
    const ResourceDecl& decl = plan.graph.resources[target.resource];
    if (decl.kind == ResourceKind::buffer) {
        const float value = target.value[0];
        const uint32_t word =
            value < 0 ? static_cast<uint32_t>(saturated<int32_t>(value)) : saturated<uint32_t>(value);
        const ByteRange bytes = piece_bytes(decl, target.range);
        fn.vkCmdFillBuffer(commands, resources.buffer(target.resource), bytes.offset_bytes,
                           bytes.end_bytes() == decl.size_bytes ? VK_WHOLE_SIZE : bytes.size_bytes, word);
        return;
    }
    const VkImage image = resources.image(target.resource);
    const VkImageLayout layout = to_vk(target.layout);
    const VkImageSubresourceRange range = to_vk(target.range);
    if (target.range.aspects & aspect::kColor) {
        const VkClearColorValue value = clear_color(decl.format, target.value);
        fn.vkCmdClearColorImage(commands, image, layout, &value, 1, &range);
        return;
    }
    const VkClearDepthStencilValue value{target.value[0], saturated<uint32_t>(target.value[1])};
    fn.vkCmdClearDepthStencilImage(commands, image, layout, &value, 1, &range);
}

void record_first_content(const Device& device, VkCommandBuffer commands, const FramePlan& plan,
                          const FrameResources& resources, std::span<const ResourceId> cleared) {
    for (const ResourceId id : cleared) {
        const ResourceDecl& decl = plan.graph.resources[id];
        record_clear_of(device, commands, plan, resources,
                        {id, decl.whole(), Layout::transfer_dst, decl.first_frame});
    }
}

void record_prologue(const Device& device, VkCommandBuffer commands, const FramePlan& plan,
                     const ResourceTable& resources) {
    const ProloguePlan& prologue = plan.barriers.prologue;
    const FrameResources first(resources, 0);
    record_barriers(device, commands, prologue.before, plan, first);
    record_first_content(device, commands, plan, first, prologue.cleared);
    record_barriers(device, commands, prologue.after, plan, first);
}

}  // namespace weft::vk
