#include "vulkan/memory/uploader.h"

#include <cstring>

#include "vulkan/device/executor_errors.h"
#include "vulkan/device/functions.h"
#include "vulkan/memory/upload_copies.h"

namespace weft::vk {

Result<std::unique_ptr<UploadBatch>> UploadBatch::create(Device& device) {
    std::unique_ptr<UploadBatch> batch(new UploadBatch(device));
    if (const VkResult result = batch->once_.open(device); result != VK_SUCCESS)
        return failed_call("V418", "beginning the upload of a part of the scene", result);
    return batch;
}

Result<const Buffer*> UploadBatch::add_staging(uint64_t size_bytes) {
    Result<Buffer> staging = Buffer::create(device_, size_bytes, VK_BUFFER_USAGE_TRANSFER_SRC_BIT,
                                            Buffer::Memory::upload, "staging memory of a part of the scene");
    if (!staging) return staging.take_errors();
    staging_.push_back(std::make_unique<Buffer>(std::move(*staging)));
    return staging_.back().get();
}

Status UploadBatch::buffer(const Buffer& target, std::span<const std::byte> bytes) {
    if (bytes.empty()) return Unit{};
    if (bytes.size() > target.size_bytes())
        return size_error("the data for the buffer", bytes.size(), target.size_bytes());
    Result<const Buffer*> staging = add_staging(bytes.size());
    if (!staging) return staging.take_errors();
    std::memcpy((*staging)->mapped().data(), bytes.data(), bytes.size());
    record_buffer_copy(device_.fn(), once_.commands, target, **staging, {0, 0, bytes.size()});
    return Unit{};
}

Status UploadBatch::image(const Image& target, std::span<const std::span<const std::byte>> levels) {
    Result<std::vector<VkBufferImageCopy>> copies = plan_copies(target.decl(), levels);
    if (!copies) return copies.take_errors();
    Result<const Buffer*> staging = add_staging(copies->back().bufferOffset + levels.back().size());
    if (!staging) return staging.take_errors();
    fill_staging((*staging)->mapped(), *copies, levels);
    record_image_copy(device_.fn(), once_.commands, target, **staging, *copies);
    return Unit{};
}

Status UploadBatch::end() {
    const VkResult result = device_.fn().vkEndCommandBuffer(once_.commands);
    if (result == VK_SUCCESS) return Unit{};
    return failed_call("V418", "recording the upload of a part of the scene", result);
}

Status UploadBatch::submit() {
    const VkResult result = once_.submit(device_);
    if (result != VK_SUCCESS) return failed_call("V418", "uploading a part of the scene", result);
    submitted_ = true;
    return Unit{};
}

bool UploadBatch::is_over() const {
    return device_.fn().vkGetFenceStatus(device_.handle(), once_.fence.get()) == VK_SUCCESS;
}

UploadBatch::~UploadBatch() {
    if (!submitted_ || device_.abandoned()) return;
    const VkResult wait = once_.wait(device_);
    // After a failed wait, the copies may still run, so their objects must not be destroyed. A lost device is
    // an exception, because it runs nothing any more.
    if (wait != VK_SUCCESS && wait != VK_ERROR_DEVICE_LOST) device_.abandon();
}

}  // namespace weft::vk
