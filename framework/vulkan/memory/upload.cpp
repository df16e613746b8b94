#include <algorithm>
#include <cassert>
#include <cstring>
#include <functional>
#include <memory>
#include <vector>

#include "vulkan/device/functions.h"
#include "vulkan/device/immediate_submit.h"
#include "vulkan/device/to_vk.h"
#include "weft/vulkan/memory.h"

namespace weft::vk {
namespace {

// Alignment of each mip level in staging memory, in bytes. Copy offsets must be multiples of the texel size
// (1, 2, 4, 8 or 16 bytes); for depth and stencil, also multiples of 4.
constexpr uint64_t kStagingAlignmentBytes = 16;
// The data for a buffer is uploaded in pieces of at most 16 MiB.
constexpr size_t kStagingBytes = 16 << 20;

uint64_t align_up(uint64_t value) {
    return (value + kStagingAlignmentBytes - 1) / kStagingAlignmentBytes * kStagingAlignmentBytes;
}

Diagnostic size_error(const std::string& what, uint64_t found, uint64_t wanted, const char* unit = " bytes") {
    Diagnostic error;
    error.code = "V420";
    error.message = what + " has " + std::to_string(found) + unit + "; wanted " + std::to_string(wanted);
    error.help = {"pack the texels without gaps, and store the layers of a mip one after the other"};
    return error;
}

uint64_t level_bytes(const ResourceDecl& decl, uint32_t mip) {
    const Extent3D extent = mip_extent(decl.extent, mip);
    return uint64_t{extent.width} * extent.height * extent.depth * decl.layers *
           format_info(decl.format).bytes_per_texel;
}

// Returns the copy region of each mip level, with its offset in staging memory. Returns an error if the
// number or the size of the levels is wrong.
Result<std::vector<VkBufferImageCopy>> plan_copies(const ResourceDecl& decl,
                                                   std::span<const std::span<const std::byte>> levels) {
    if (levels.empty() || levels.size() > decl.mips) {
        return size_error("the list of mips of \"" + decl.name + "\"", levels.size(), decl.mips, " mips");
    }
    std::vector<VkBufferImageCopy> copies;
    uint64_t offset = 0;
    for (uint32_t mip = 0; mip < levels.size(); ++mip) {
        if (levels[mip].size() != level_bytes(decl, mip)) {
            return size_error("mip " + std::to_string(mip) + " of \"" + decl.name + "\"", levels[mip].size(),
                              level_bytes(decl, mip));
        }
        VkBufferImageCopy copy{};
        copy.bufferOffset = offset;
        copy.imageSubresource = layers_to_vk({mip, 1, 0, decl.layers, decl.aspects});
        copy.imageExtent = to_vk(mip_extent(decl.extent, mip));
        copies.push_back(copy);
        offset = align_up(offset + levels[mip].size());
    }
    return copies;
}

VkImageMemoryBarrier2 whole_image_barrier(const Image& image) {
    VkImageMemoryBarrier2 barrier{};
    barrier.sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2;
    barrier.srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    barrier.image = image.handle();
    barrier.subresourceRange = to_vk(image.decl().whole());
    return barrier;
}

void record_barrier(const DeviceFunctions& fn, VkCommandBuffer commands,
                    const VkImageMemoryBarrier2& barrier) {
    VkDependencyInfo dependency{};
    dependency.sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO;
    dependency.imageMemoryBarrierCount = 1;
    dependency.pImageMemoryBarriers = &barrier;
    fn.vkCmdPipelineBarrier2(commands, &dependency);
}

void record_image_copy(const DeviceFunctions& fn, VkCommandBuffer commands, const Image& target,
                       const Buffer& staging, const std::vector<VkBufferImageCopy>& copies) {
    VkImageMemoryBarrier2 before = whole_image_barrier(target);
    before.dstStageMask = VK_PIPELINE_STAGE_2_COPY_BIT;
    before.dstAccessMask = VK_ACCESS_2_TRANSFER_WRITE_BIT;
    before.newLayout = VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL;
    record_barrier(fn, commands, before);
    fn.vkCmdCopyBufferToImage(commands, staging.handle(), target.handle(),
                              VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, static_cast<uint32_t>(copies.size()),
                              copies.data());
    VkImageMemoryBarrier2 after = whole_image_barrier(target);
    after.srcStageMask = VK_PIPELINE_STAGE_2_COPY_BIT;
    after.srcAccessMask = VK_ACCESS_2_TRANSFER_WRITE_BIT;
    after.dstStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
    after.dstAccessMask = VK_ACCESS_2_MEMORY_READ_BIT | VK_ACCESS_2_MEMORY_WRITE_BIT;
    after.oldLayout = VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL;
    const bool is_color = (target.decl().aspects & aspect::kColor) != 0;
    after.newLayout = to_vk(is_color ? Layout::shader_read_only : Layout::depth_read_only);
    record_barrier(fn, commands, after);
}

void record_buffer_copy(const DeviceFunctions& fn, VkCommandBuffer commands, const Buffer& target,
                        const Buffer& staging, const VkBufferCopy& region) {
    fn.vkCmdCopyBuffer(commands, staging.handle(), target.handle(), 1, &region);
    VkMemoryBarrier2 barrier{};
    barrier.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER_2;
    barrier.srcStageMask = VK_PIPELINE_STAGE_2_COPY_BIT;
    barrier.srcAccessMask = VK_ACCESS_2_TRANSFER_WRITE_BIT;
    barrier.dstStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
    barrier.dstAccessMask = VK_ACCESS_2_MEMORY_READ_BIT | VK_ACCESS_2_MEMORY_WRITE_BIT;
    VkDependencyInfo dependency{};
    dependency.sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO;
    dependency.memoryBarrierCount = 1;
    dependency.pMemoryBarriers = &barrier;
    fn.vkCmdPipelineBarrier2(commands, &dependency);
}

// Creates staging memory, fills it with `fill`, records the copy to the target with `record`, and waits until
// the copy has finished.
Status copy_from_staging(Device& device, const std::string& what, uint64_t size_bytes,
                         const std::function<void(std::span<std::byte>)>& fill,
                         const std::function<void(VkCommandBuffer, const Buffer&)>& record) {
    Result<Buffer> staging =
        Buffer::create(device, size_bytes, VK_BUFFER_USAGE_TRANSFER_SRC_BIT, Buffer::Memory::upload, what);
    if (!staging) return staging.take_errors();
    fill(staging->mapped());
    return immediate_submit(device, what, [&](VkCommandBuffer commands) { record(commands, *staging); });
}

}  // namespace

Status upload_buffer(Device& device, const Buffer& target, std::span<const std::byte> bytes) {
    if (bytes.empty()) return Unit{};
    if (bytes.size() > target.size_bytes()) {
        return size_error("the data for the buffer", bytes.size(), target.size_bytes());
    }
    // The data is uploaded in pieces, so that the staging memory stays small for any size of buffer.
    for (size_t offset = 0; offset < bytes.size(); offset += kStagingBytes) {
        const std::span<const std::byte> piece =
            bytes.subspan(offset, std::min<size_t>(kStagingBytes, bytes.size() - offset));
        Status copied = copy_from_staging(
            device, "uploading a buffer", piece.size(),
            [&](std::span<std::byte> staging) { std::memcpy(staging.data(), piece.data(), piece.size()); },
            [&](VkCommandBuffer commands, const Buffer& staging) {
                record_buffer_copy(device.fn(), commands, target, staging, {0, offset, piece.size()});
            });
        if (!copied) return copied;
    }
    return Unit{};
}

Status upload_image(Device& device, const Image& target, std::span<const std::span<const std::byte>> levels) {
    const ResourceDecl& decl = target.decl();
    assert((decl.usage & usage::kTransferDst) != 0);
    Result<std::vector<VkBufferImageCopy>> copies = plan_copies(decl, levels);
    if (!copies) return copies.take_errors();
    const uint64_t size_bytes = copies->back().bufferOffset + levels.back().size();
    const auto fill = [&](std::span<std::byte> staging) {
        for (size_t i = 0; i < levels.size(); ++i) {
            std::memcpy(staging.data() + (*copies)[i].bufferOffset, levels[i].data(), levels[i].size());
        }
    };
    return copy_from_staging(device, "uploading \"" + decl.name + "\"", size_bytes, fill,
                             [&](VkCommandBuffer commands, const Buffer& staging) {
                                 record_image_copy(device.fn(), commands, target, staging, *copies);
                             });
}

}  // namespace weft::vk
