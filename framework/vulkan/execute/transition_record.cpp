#include "vulkan/execute/transition_record.h"

#include <algorithm>

#include "vulkan/device/functions.h"
#include "vulkan/device/to_vk.h"
#include "vulkan/record/barriers_vk.h"
#include "vulkan/record/clears.h"

namespace weft::vk {
namespace {

VkImageSubresourceLayers layers_of(const ResourceDecl& decl, uint32_t mip) {
    SubresourceRange range = decl.whole();
    range.mip = mip;
    range.mips = 1;
    return layers_to_vk(range);
}

// Returns the size of a mip level in pixels, as the second corner in a VkImageBlit. `area` is the size of the
// first mip. The first corner of the blit is {0, 0, 0}. If only a part of the image has content, `area` is
// the size of this part.
VkOffset3D end_of(const Extent3D& area, uint32_t mip) {
    const Extent3D extent = mip_extent(area, mip);
    return {static_cast<int32_t>(extent.width), static_cast<int32_t>(extent.height),
            static_cast<int32_t>(extent.depth)};
}

struct Images {
    const ResourceDecl& old_decl;
    const ResourceDecl& decl;
    VkImage from;
    VkImage to;
    Extent3D old_area;  // The part of the old image that has content.
    Extent3D area;      // The part of the new image that gets content by a blit.
};

// Returns true if a linear filter reads only texels that have content. If only a part of the old image has
// content and the blit enlarges this part, the filter also reads the texels next to this part.
bool reads_only_content(const Images& images) {
    const Extent3D &from = images.old_area, &to = images.area;
    return from == images.old_decl.extent || (to.width <= from.width && to.height <= from.height);
}

void stretch(const Device& device, VkCommandBuffer commands, const Images& images) {
    const bool blends =
        format_info(images.decl.format).numeric == NumericClass::float_like && reads_only_content(images);
    std::vector<VkImageBlit> blits;
    for (uint32_t mip = 0; mip < images.decl.mips; ++mip) {
        const uint32_t old_mip = std::min(mip, images.old_decl.mips - 1);
        VkImageBlit blit{};
        blit.srcSubresource = layers_of(images.old_decl, old_mip);
        blit.srcOffsets[1] = end_of(images.old_area, old_mip);
        blit.dstSubresource = layers_of(images.decl, mip);
        blit.dstOffsets[1] = end_of(images.area, mip);
        blits.push_back(blit);
    }
    device.fn().vkCmdBlitImage(commands, images.from, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, images.to,
                               VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, static_cast<uint32_t>(blits.size()),
                               blits.data(), blends ? VK_FILTER_LINEAR : VK_FILTER_NEAREST);
}

void copy(const Device& device, VkCommandBuffer commands, const Images& images) {
    std::vector<VkImageCopy> copies;
    for (uint32_t mip = 0; mip < images.decl.mips; ++mip) {
        VkImageCopy region{};
        region.srcSubresource = layers_of(images.old_decl, mip);
        region.dstSubresource = layers_of(images.decl, mip);
        region.extent = to_vk(mip_extent(images.decl.extent, mip));
        copies.push_back(region);
    }
    device.fn().vkCmdCopyImage(commands, images.from, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, images.to,
                               VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, static_cast<uint32_t>(copies.size()),
                               copies.data());
}

void record_copies(const Device& device, VkCommandBuffer commands, const ContentCopy& carry,
                   const PlanSide& from, const PlanSide& to) {
    const ResourceDecl& decl = to.plan.graph.resources[carry.to];
    if (decl.kind == ResourceKind::buffer) {
        const VkBufferCopy region{0, 0, decl.size_bytes};
        device.fn().vkCmdCopyBuffer(commands, from.resources.buffer(carry.from),
                                    to.resources.buffer(carry.to), 1, &region);
        return;
    }
    const Images images{
        from.plan.graph.resources[carry.from],
        decl,
        from.resources.image(carry.from),
        to.resources.image(carry.to),
        from.areas.area_before(from.plan.graph, carry.from, from.resources.rings(), from.resources.frame()),
        to.areas.area(carry.to)};
    carry.resample ? stretch(device, commands, images) : copy(device, commands, images);
}

}  // namespace

void record_transition(const Device& device, VkCommandBuffer commands, const TransitionPlan& transition,
                       const PlanSide& from, const PlanSide& to) {
    record_barriers(device, commands, transition.before_old, from.plan, from.resources);
    record_barriers(device, commands, transition.before, to.plan, to.resources);
    for (const ContentCopy& carry : transition.carried)
        if (!carry.shared) record_copies(device, commands, carry, from, to);
    record_first_content(device, commands, to.plan, to.resources, transition.cleared);
    record_barriers(device, commands, transition.after, to.plan, to.resources);
}

}  // namespace weft::vk
