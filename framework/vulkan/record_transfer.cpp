// Clear and copy passes.
#include <algorithm>

#include "vulkan/record.h"
#include "vulkan/to_vk.h"

namespace weft::vk {
namespace {

void clear_image(const RecordContext& context, const PassDecl& pass, const UseDecl& use) {
    const ResourceDecl& decl = context.objects.plan.graph.resources[use.resource];
    const VkImage image = context.objects.resources.images[use.resource];
    const VkImageLayout layout = to_vk(use.state.layout);
    const VkImageSubresourceRange range = to_vk(use.range);
    const DeviceFunctions& fn = context.device.fn();
    if (use.range.aspects & aspect::kColor) {
        const VkClearColorValue value = clear_color(decl.format, pass.clear);
        fn.vkCmdClearColorImage(context.commands, image, layout, &value, 1, &range);
        return;
    }
    const VkClearDepthStencilValue value{pass.clear[0], static_cast<uint32_t>(pass.clear[1])};
    fn.vkCmdClearDepthStencilImage(context.commands, image, layout, &value, 1, &range);
}

void copy_images(const RecordContext& context, const UseDecl& from, const UseDecl& to) {
    const FramePlan& plan = context.objects.plan;
    const Extent3D& source_extent = plan.graph.resources[from.resource].extent;
    std::vector<VkImageCopy> copies;
    for (uint32_t i = 0; i < std::min(from.range.mips, to.range.mips); ++i) {
        VkImageCopy copy{};
        copy.srcSubresource = layers_to_vk(from.range);
        copy.srcSubresource.mipLevel = from.range.mip + i;
        copy.dstSubresource = layers_to_vk(to.range);
        copy.dstSubresource.mipLevel = to.range.mip + i;
        copy.extent = to_vk(mip_extent(source_extent, from.range.mip + i));
        copies.push_back(copy);
    }
    context.device.fn().vkCmdCopyImage(context.commands, context.objects.resources.images[from.resource],
                                       to_vk(from.state.layout),
                                       context.objects.resources.images[to.resource], to_vk(to.state.layout),
                                       static_cast<uint32_t>(copies.size()), copies.data());
}

}  // namespace

void record_clear(const RecordContext& context, const PassDecl& pass) {
    for (const UseDecl& use : pass.uses) {
        const VkBuffer buffer = context.objects.resources.buffers[use.resource];
        if (buffer == VK_NULL_HANDLE) {
            clear_image(context, pass, use);
            continue;
        }
        // Buffers are words: a clear value of 7 is the integer 7.
        const auto word = static_cast<uint32_t>(static_cast<int64_t>(pass.clear[0]));
        context.device.fn().vkCmdFillBuffer(context.commands, buffer, 0, VK_WHOLE_SIZE, word);
    }
}

void record_copy(const RecordContext& context, const PassDecl& pass) {
    const UseDecl& from = pass.uses[0].is_output ? pass.uses[1] : pass.uses[0];
    const UseDecl& to = pass.uses[0].is_output ? pass.uses[0] : pass.uses[1];
    const FramePlan& plan = context.objects.plan;
    if (plan.graph.resources[from.resource].kind == ResourceKind::image)
        return copy_images(context, from, to);
    const VkBufferCopy copy{0, 0,
                            std::min(plan.graph.resources[from.resource].size_bytes,
                                     plan.graph.resources[to.resource].size_bytes)};
    context.device.fn().vkCmdCopyBuffer(context.commands, context.objects.resources.buffers[from.resource],
                                        context.objects.resources.buffers[to.resource], 1, &copy);
}

}  // namespace weft::vk
