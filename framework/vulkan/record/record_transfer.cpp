// This file records clear, copy and blit passes.
#include <algorithm>

#include "vulkan/device/functions.h"
#include "vulkan/device/to_vk.h"
#include "vulkan/record/clears.h"
#include "vulkan/record/record.h"

namespace weft::vk {
namespace {

// Makes `region` a VkImageCopy or VkImageBlit from mip `i` of the range `from` to mip `i` of the range `to`.
template <class Region>
void select_mip(Region& region, const SubresourceRange& from, const SubresourceRange& to, uint32_t i) {
    region.srcSubresource = layers_to_vk(from);
    region.srcSubresource.mipLevel = from.mip + i;
    region.dstSubresource = layers_to_vk(to);
    region.dstSubresource.mipLevel = to.mip + i;
}

void copy_images(const RecordContext& context, const UseDecl& from, const UseDecl& to) {
    std::vector<VkImageCopy> copies;
    for (uint32_t i = 0; i < std::min(from.range.mips, to.range.mips); ++i) {
        VkImageCopy copy{};
        select_mip(copy, from.range, to.range, i);
        copy.extent = to_vk(context.objects.areas.area(from.resource, from.range.mip + i));
        copies.push_back(copy);
    }
    context.device.fn().vkCmdCopyImage(context.commands, context.resources.image(from.resource),
                                       to_vk(from.state.layout), context.resources.image(to.resource),
                                       to_vk(to.state.layout), static_cast<uint32_t>(copies.size()),
                                       copies.data());
}

VkOffset3D far_corner(const Extent3D& extent) {
    return {static_cast<int32_t>(extent.width), static_cast<int32_t>(extent.height),
            static_cast<int32_t>(extent.depth)};
}

// Blits each mip level of the range `from` to the mip level with the same position in the range `to`. If an
// image has a live size, only its area in this frame is read or written.
void blit_images(const RecordContext& context, const UseDecl& from, const UseDecl& to) {
    const FrameAreas& areas = context.objects.areas;
    std::vector<VkImageBlit> blits;
    for (uint32_t i = 0; i < std::min(from.range.mips, to.range.mips); ++i) {
        VkImageBlit blit{};
        select_mip(blit, from.range, to.range, i);
        blit.srcOffsets[1] = far_corner(areas.area(from.resource, from.range.mip + i));
        blit.dstOffsets[1] = far_corner(areas.area(to.resource, to.range.mip + i));
        blits.push_back(blit);
    }
    context.device.fn().vkCmdBlitImage(context.commands, context.resources.image(from.resource),
                                       to_vk(from.state.layout), context.resources.image(to.resource),
                                       to_vk(to.state.layout), static_cast<uint32_t>(blits.size()),
                                       blits.data(), to_vk(from.sampler.filter));
}

}  // namespace

void record_clear(const RecordContext& context, const PassDecl& pass) {
    for (const UseDecl& use : pass.uses)
        record_clear_of(context.device, context.commands, context.objects.plan, context.resources,
                        {use.resource, use.range, use.state.layout, pass.clear});
}

void record_copy(const RecordContext& context, const PassDecl& pass) {
    const UseDecl& from = pass.uses[0].is_output ? pass.uses[1] : pass.uses[0];
    const UseDecl& to = pass.uses[0].is_output ? pass.uses[0] : pass.uses[1];
    const FramePlan& plan = context.objects.plan;
    if (from.access == Access::blit_read) return blit_images(context, from, to);
    if (plan.graph.resources[from.resource].kind == ResourceKind::image)
        return copy_images(context, from, to);
    const ByteRange source = used_bytes(plan.graph.resources[from.resource], from);
    const ByteRange target = used_bytes(plan.graph.resources[to.resource], to);
    const VkBufferCopy copy{source.offset_bytes, target.offset_bytes,
                            std::min(source.size_bytes, target.size_bytes)};
    context.device.fn().vkCmdCopyBuffer(context.commands, context.resources.buffer(from.resource),
                                        context.resources.buffer(to.resource), 1, &copy);
}

}  // namespace weft::vk
