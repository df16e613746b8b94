#include "vulkan/memory/upload_copies.h"

#include <cstring>

#include "graph/diagnostics/make_error.h"
#include "vulkan/device/to_vk.h"

namespace weft::vk {
namespace {

// Alignment of each mip level in staging memory, in bytes. Copy offsets must be multiples of the texel size
// (1, 2, 4, 8 or 16 bytes); for depth and stencil, also multiples of 4.
constexpr uint64_t kStagingAlignmentBytes = 16;
uint64_t align_up(uint64_t value) {
    return (value + kStagingAlignmentBytes - 1) / kStagingAlignmentBytes * kStagingAlignmentBytes;
}

uint64_t level_bytes(const ResourceDecl& decl, uint32_t mip) {
    const Extent3D extent = mip_extent(decl.extent, mip);
    return uint64_t{extent.width} * extent.height * extent.depth * decl.layers *
           format_info(decl.format).bytes_per_texel;
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

}  // namespace

Diagnostic size_error(const std::string& what, uint64_t found, uint64_t wanted, const char* unit) {
    return make_error("V420",
                      what + " has " + std::to_string(found) + unit + "; wanted " + std::to_string(wanted),
                      {"pack the texels without gaps, and store the layers of a mip one after the other"});
}

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

void fill_staging(std::span<std::byte> staging, const std::vector<VkBufferImageCopy>& copies,
                  std::span<const std::span<const std::byte>> levels) {
    for (size_t i = 0; i < levels.size(); ++i)
        std::memcpy(staging.data() + copies[i].bufferOffset, levels[i].data(), levels[i].size());
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

}  // namespace weft::vk
