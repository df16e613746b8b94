// Purpose: records copies of new data from staging memory to a buffer or an image, with the barriers that
// make the data visible to all later commands of the queue. Errors: V420 (sizes do not match).
#pragma once

#include <span>
#include <vector>

#include "vulkan/device/functions.h"
#include "weft/vulkan/memory.h"

namespace weft::vk {

[[nodiscard]] Diagnostic size_error(const std::string& what, uint64_t found, uint64_t wanted,
                                    const char* unit = " bytes");
// Returns the copy region of each mip level, with its offset in staging memory. Returns an error if the
// number or the size of the levels is wrong.
[[nodiscard]] Result<std::vector<VkBufferImageCopy>> plan_copies(
    const ResourceDecl& decl, std::span<const std::span<const std::byte>> levels);
// Copies all levels to their places in staging memory.
void fill_staging(std::span<std::byte> staging, const std::vector<VkBufferImageCopy>& copies,
                  std::span<const std::span<const std::byte>> levels);
void record_image_copy(const DeviceFunctions& fn, VkCommandBuffer commands, const Image& target,
                       const Buffer& staging, const std::vector<VkBufferImageCopy>& copies);
void record_buffer_copy(const DeviceFunctions& fn, VkCommandBuffer commands, const Buffer& target,
                        const Buffer& staging, const VkBufferCopy& region);

}  // namespace weft::vk
