#include <algorithm>
#include <cassert>
#include <cstring>
#include <functional>
#include <memory>
#include <vector>

#include "vulkan/device/functions.h"
#include "vulkan/device/immediate_submit.h"
#include "vulkan/memory/upload_copies.h"
#include "weft/vulkan/memory.h"

namespace weft::vk {
namespace {

// The data for a buffer is uploaded in pieces of at most 16 MiB.
constexpr size_t kStagingBytes = 16 << 20;

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
    const auto fill = [&](std::span<std::byte> staging) { fill_staging(staging, *copies, levels); };
    return copy_from_staging(device, "uploading \"" + decl.name + "\"", size_bytes, fill,
                             [&](VkCommandBuffer commands, const Buffer& staging) {
                                 record_image_copy(device.fn(), commands, target, staging, *copies);
                             });
}

}  // namespace weft::vk
