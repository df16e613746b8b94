// Purpose: copies the data of new objects to the device: either at once, or all together with one submission
// that the host does not wait for. Errors: those of upload_buffer(); V409, V410, V418.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "vulkan/device/one_time_commands.h"
#include "weft/result.h"
#include "weft/vulkan/memory.h"

namespace weft::vk {

class Uploader {
 public:
    virtual ~Uploader() = default;
    // Copy data to the target, like upload_buffer() and upload_image().
    [[nodiscard]] virtual Status buffer(const Buffer& target, std::span<const std::byte> bytes) = 0;
    [[nodiscard]] virtual Status image(const Image& target,
                                       std::span<const std::span<const std::byte>> levels) = 0;
};

// Copies at once, and waits for each copy. Must be called on the thread that submits.
class ImmediateUploader final : public Uploader {
 public:
    explicit ImmediateUploader(Device& device) : device_(device) {}
    Status buffer(const Buffer& target, std::span<const std::byte> bytes) override {
        return upload_buffer(device_, target, bytes);
    }
    Status image(const Image& target, std::span<const std::span<const std::byte>> levels) override {
        return upload_image(device_, target, levels);
    }

 private:
    Device& device_;
};

// Records copies on any thread: create(), then buffer() and image(), then end(). On the thread that submits,
// submit() starts the copies. The targets must live until the copies have finished. The destructor waits for
// them.
class UploadBatch final : public Uploader {
 public:
    [[nodiscard]] static Result<std::unique_ptr<UploadBatch>> create(Device& device);
    ~UploadBatch() override;
    UploadBatch(const UploadBatch&) = delete;
    UploadBatch& operator=(const UploadBatch&) = delete;

    Status buffer(const Buffer& target, std::span<const std::byte> bytes) override;
    Status image(const Image& target, std::span<const std::span<const std::byte>> levels) override;
    [[nodiscard]] Status end();
    // Submits the copies to the main queue. All later submissions to this queue see the data.
    [[nodiscard]] Status submit();
    // Returns true if the submitted copies have finished. Does not wait.
    [[nodiscard]] bool is_over() const;

 private:
    explicit UploadBatch(Device& device) : device_(device) {}
    [[nodiscard]] Result<const Buffer*> add_staging(uint64_t size_bytes);

    Device& device_;
    OneTimeCommands once_;
    std::vector<std::unique_ptr<Buffer>> staging_;
    bool submitted_ = false;
};

}  // namespace weft::vk
