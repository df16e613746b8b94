#include "vulkan/memory/readback.h"

#include <algorithm>

#include "vulkan/device/executor_errors.h"
#include "vulkan/device/functions.h"
#include "vulkan/device/immediate_submit.h"
#include "vulkan/device/to_vk.h"
#include "vulkan/memory/places.h"

namespace weft::vk {
namespace {

void host_visibility_barrier(const Device& device, VkCommandBuffer commands, VkBuffer buffer) {
    VkBufferMemoryBarrier2 barrier{VK_STRUCTURE_TYPE_BUFFER_MEMORY_BARRIER_2};
    barrier.srcStageMask = VK_PIPELINE_STAGE_2_COPY_BIT;
    barrier.srcAccessMask = VK_ACCESS_2_TRANSFER_WRITE_BIT;
    barrier.dstStageMask = VK_PIPELINE_STAGE_2_HOST_BIT;
    barrier.dstAccessMask = VK_ACCESS_2_HOST_READ_BIT;
    barrier.srcQueueFamilyIndex = barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    barrier.buffer = buffer;
    barrier.size = VK_WHOLE_SIZE;
    VkDependencyInfo info{VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
    info.bufferMemoryBarrierCount = 1;
    info.pBufferMemoryBarriers = &barrier;
    device.fn().vkCmdPipelineBarrier2(commands, &info);
}

}  // namespace

Result<uint64_t> ReadbackMemory::lay_out(const FramePlan& plan) {
    uint64_t size_bytes = 0;
    for (Position position(0); position < plan.schedule.order.size(); ++position) {
        const PassDecl& pass = plan.graph.passes[plan.schedule.order[position]];
        if (pass.kind != PassKind::readback) continue;
        if (pass.uses.size() != 1)
            return pass_error(plan, pass, "V417", "a readback pass needs exactly one input");
        const UseDecl& use = pass.uses[0];
        const ResourceDecl& decl = plan.graph.resources[use.resource];
        size_bytes = aligned_place(size_bytes);
        Place place{position, size_bytes, {}, {}};
        if (decl.kind == ResourceKind::buffer)
            place.buffer = used_bytes(decl, use);
        else
            place.regions = image_regions(decl, use.range, size_bytes);
        size_bytes +=
            decl.kind == ResourceKind::buffer ? place.buffer.size_bytes : place.regions.staging_bytes;
        places_.push_back(std::move(place));
    }
    return size_bytes;
}

Result<ReadbackMemory> ReadbackMemory::create(Device& device, const FramePlan& plan) {
    ReadbackMemory memory;
    Result<uint64_t> size_bytes = memory.lay_out(plan);
    if (!size_bytes) return size_bytes.take_errors();
    Status made = create_slot_buffers(memory.memory_, device, *size_bytes, VK_BUFFER_USAGE_TRANSFER_DST_BIT,
                                      Buffer::Memory::readback, "readback");
    if (!made) return made.take_errors();
    return memory;
}

ImageRegions ReadbackMemory::regions_of(const Place& place, const ResourceDecl& decl, const UseDecl& use,
                                        const Extent3D& area) {
    if (area == decl.extent) return place.regions;
    ResourceDecl part = decl;
    part.extent = area;
    return image_regions(part, use.range, place.offset_bytes);
}

void ReadbackMemory::record(const Device& device, VkCommandBuffer commands, Position position, uint32_t slot,
                            const FramePlan& plan, const FrameResources& resources,
                            const FrameAreas& areas) const {
    const UseDecl& use = plan.graph.passes[plan.schedule.order[position]].uses[0];
    for (const Place& place : places_) {
        if (place.position != position) continue;
        if (place.buffer.size_bytes != 0) {
            const VkBufferCopy copy{place.buffer.offset_bytes, place.offset_bytes, place.buffer.size_bytes};
            device.fn().vkCmdCopyBuffer(commands, resources.buffer(use.resource), memory_[slot].handle(), 1,
                                        &copy);
            continue;
        }
        const ImageRegions regions =
            regions_of(place, plan.graph.resources[use.resource], use, areas.area(use.resource));
        device.fn().vkCmdCopyImageToBuffer(
            commands, resources.image(use.resource), to_vk(use.state.layout), memory_[slot].handle(),
            static_cast<uint32_t>(regions.copies.size()), regions.copies.data());
    }
}

void ReadbackMemory::record_visibility(const Device& device, VkCommandBuffer commands, uint32_t slot,
                                       const Batch& batch) const {
    const bool copies = std::any_of(places_.begin(), places_.end(), [&](const Place& place) {
        return std::find(batch.positions.begin(), batch.positions.end(), place.position) !=
               batch.positions.end();
    });
    if (copies) host_visibility_barrier(device, commands, memory_[slot].handle());
}

void ReadbackMemory::deliver(const FramePlan& plan, uint32_t slot, uint64_t frame_index,
                             const FrameShape& frame, std::vector<ReadbackData>& out) const {
    for (const Place& place : places_) {
        const PassDecl& pass = plan.graph.passes[plan.schedule.order[place.position]];
        if (!has_combination(pass.runs_in, frame.switches)) continue;
        const ResourceDecl& decl = plan.graph.resources[pass.uses[0].resource];
        ReadbackData data;
        data.pass = pass.name;
        data.frame_index = frame_index;
        const std::span<const std::byte> staging = memory_[slot].mapped();
        if (place.buffer.size_bytes != 0) {
            const auto bytes = staging.subspan(place.offset_bytes, place.buffer.size_bytes);
            data.bytes.assign(bytes.begin(), bytes.end());
        } else {
            const UseDecl& use = pass.uses[0];
            const Extent3D area = frame.areas.empty() ? decl.extent : frame.areas[use.resource];
            data.format = decl.format;
            data.extent = mip_extent(area, use.range.mip);
            data.bytes = pack(regions_of(place, decl, use, area), staging);
        }
        out.push_back(std::move(data));
    }
}

Result<ReadbackData> read_image_now(Device& device, const Image& image) {
    const ResourceDecl& decl = image.decl();
    const ImageRegions regions = image_regions(decl, decl.whole(), 0);
    Result<Buffer> staging = Buffer::create(device, regions.staging_bytes, VK_BUFFER_USAGE_TRANSFER_DST_BIT,
                                            Buffer::Memory::readback, "reading " + decl.name);
    if (!staging) return staging.take_errors();
    Status read =
        immediate_submit(device, "reading image \"" + decl.name + "\"", [&](VkCommandBuffer commands) {
            device.fn().vkCmdCopyImageToBuffer(
                commands, image.handle(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, staging->handle(),
                static_cast<uint32_t>(regions.copies.size()), regions.copies.data());
            host_visibility_barrier(device, commands, staging->handle());
        });
    if (!read) return read.take_errors();
    ReadbackData data;
    data.format = decl.format;
    data.extent = decl.extent;
    data.bytes = pack(regions, staging->mapped());
    return data;
}

}  // namespace weft::vk
