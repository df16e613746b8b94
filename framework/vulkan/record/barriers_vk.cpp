#include "vulkan/record/barriers_vk.h"

#include "vulkan/device/functions.h"
#include "vulkan/device/plan_queues.h"
#include "vulkan/device/to_vk.h"

namespace weft::vk {
namespace {

struct Families {
    uint32_t src = VK_QUEUE_FAMILY_IGNORED;
    uint32_t dst = VK_QUEUE_FAMILY_IGNORED;
};

Families families_of(const Device& device, const BarrierDecl& barrier) {
    const Families families{device_family(device, barrier.src_family),
                            device_family(device, barrier.dst_family)};
    return families.src == families.dst ? Families{} : families;
}

// Returns the old layout of an image barrier. Both barriers of an ownership transfer, release and acquire,
// contain the layout change. If the device has only one family for both families of the plan, there is no
// transfer. In this case, only the release changes the layout: the old layout of the acquire is the same as
// its new layout.
VkImageLayout old_layout(const BarrierDecl& barrier, const Families& families) {
    const bool done = barrier.reason == BarrierReason::acquire_queue && families.src == families.dst;
    return to_vk(done ? barrier.dst.layout : barrier.src.layout);
}

// Makes a VkImageMemoryBarrier2 or a VkBufferMemoryBarrier2 with the stages, accesses and queue families of
// the barrier.
template <class Barrier>
Barrier make_barrier(VkStructureType type, const BarrierDecl& barrier, const Families& families) {
    Barrier out{type};
    out.srcStageMask = stages_to_vk(barrier.src.stages);
    out.srcAccessMask = access_to_vk(barrier.src.access);
    out.dstStageMask = stages_to_vk(barrier.dst.stages);
    out.dstAccessMask = access_to_vk(barrier.dst.access);
    out.srcQueueFamilyIndex = families.src;
    out.dstQueueFamilyIndex = families.dst;
    return out;
}

VkImageMemoryBarrier2 image_barrier(const BarrierDecl& barrier, VkImage image, const Families& families) {
    auto out =
        make_barrier<VkImageMemoryBarrier2>(VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2, barrier, families);
    out.oldLayout = old_layout(barrier, families);
    out.newLayout = to_vk(barrier.dst.layout);
    out.image = image;
    out.subresourceRange = to_vk(barrier.range);
    return out;
}

VkBufferMemoryBarrier2 buffer_barrier(const BarrierDecl& barrier, const ResourceDecl& decl, VkBuffer buffer,
                                      const Families& families) {
    auto out =
        make_barrier<VkBufferMemoryBarrier2>(VK_STRUCTURE_TYPE_BUFFER_MEMORY_BARRIER_2, barrier, families);
    const ByteRange bytes = piece_bytes(decl, barrier.range);
    out.buffer = buffer;
    out.offset = bytes.offset_bytes;
    out.size = barrier.range == decl.whole() ? VK_WHOLE_SIZE : bytes.size_bytes;
    return out;
}

// Returns the memory barrier of an alias transition. The barrier waits for accesses to the previous resource
// in the same memory. A barrier for the new resource would not cover these accesses, so the barrier is
// global. If the new resource is an image, its image barrier makes the memory visible to the new accesses.
VkMemoryBarrier2 memory_barrier(const BarrierDecl& barrier, bool is_image) {
    VkMemoryBarrier2 out{VK_STRUCTURE_TYPE_MEMORY_BARRIER_2};
    out.srcStageMask = stages_to_vk(barrier.src.stages);
    out.srcAccessMask = access_to_vk(barrier.src.access);
    out.dstStageMask = stages_to_vk(barrier.dst.stages);
    out.dstAccessMask = is_image ? VK_ACCESS_2_NONE : access_to_vk(barrier.dst.access);
    return out;
}

}  // namespace

void record_barriers(const Device& device, VkCommandBuffer commands, std::span<const BarrierDecl> barriers,
                     const FramePlan& plan, const FrameResources& resources, const FrameStep& step,
                     bool is_before) {
    std::vector<VkMemoryBarrier2> memory;
    std::vector<VkImageMemoryBarrier2> images;
    std::vector<VkBufferMemoryBarrier2> buffers;
    for (const BarrierDecl& barrier : barriers) {
        if (!step.records(barrier, is_before)) continue;
        const ResourceDecl& decl = plan.graph.resources[barrier.resource];
        const bool is_image = decl.kind == ResourceKind::image;
        const Families families = families_of(device, barrier);
        if (!barrier.aliased_from.empty()) memory.push_back(memory_barrier(barrier, is_image));
        if (is_image)
            images.push_back(image_barrier(barrier, resources.image(barrier.resource), families));
        else if (barrier.aliased_from.empty())
            buffers.push_back(buffer_barrier(barrier, decl, resources.buffer(barrier.resource), families));
    }
    if (memory.empty() && images.empty() && buffers.empty()) return;
    VkDependencyInfo info{VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
    info.memoryBarrierCount = static_cast<uint32_t>(memory.size());
    info.pMemoryBarriers = memory.data();
    info.imageMemoryBarrierCount = static_cast<uint32_t>(images.size());
    info.pImageMemoryBarriers = images.data();
    info.bufferMemoryBarrierCount = static_cast<uint32_t>(buffers.size());
    info.pBufferMemoryBarriers = buffers.data();
    device.fn().vkCmdPipelineBarrier2(commands, &info);
}

}  // namespace weft::vk
