// Purpose: buffers and images with memory of their own, for what lives outside a plan's transient heap: scene
// assets, the output, staging. Move-only; destroyed with their device still alive and no work pending on
// them. Units: bytes. Errors: V407 time-out, V408 device lost, V410 out of memory, V420 sizes do not match,
// V421 the device has no such image.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "weft/declaration.h"
#include "weft/result.h"
#include "weft/vulkan/device.h"

namespace weft::vk {

// All families that the device has queues of may use it.
class Buffer {
 public:
    enum class Memory : uint8_t { device, upload, readback };  // the last two are mapped and coherent

    [[nodiscard]] static Result<Buffer> create(Device& device, uint64_t size_bytes, VkBufferUsageFlags usage,
                                               Memory memory, const std::string& name);
    Buffer() = default;
    ~Buffer();
    Buffer(Buffer&& other) noexcept;
    Buffer& operator=(Buffer&& other) noexcept;

    [[nodiscard]] VkBuffer handle() const { return buffer_; }
    [[nodiscard]] uint64_t size_bytes() const { return size_bytes_; }
    [[nodiscard]] std::span<std::byte> mapped() const { return {mapped_, mapped_ ? size_bytes_ : 0}; }

 private:
    Device* device_ = nullptr;
    VkBuffer buffer_ = VK_NULL_HANDLE;
    VkDeviceMemory memory_ = VK_NULL_HANDLE;
    uint64_t size_bytes_ = 0;
    std::byte* mapped_ = nullptr;
};

// All families that the device has queues of may use it; an import that is not declared concurrent stays
// with one.
class Image {
 public:
    // Format, extent, mips, layers, samples and usage are those of `decl`. The view covers all of it; it
    // is null where no usage can have one (only copied).
    [[nodiscard]] static Result<Image> create(Device& device, const ResourceDecl& decl);
    // An embedder's image, made as image_create_info(decl) says; it shall outlive this, which owns the view
    // only.
    [[nodiscard]] static Result<Image> adopt(Device& device, VkImage image, const ResourceDecl& decl);
    Image() = default;
    ~Image();
    Image(Image&& other) noexcept;
    Image& operator=(Image&& other) noexcept;

    [[nodiscard]] VkImage handle() const { return image_; }
    [[nodiscard]] VkImageView view() const { return view_; }
    [[nodiscard]] const ResourceDecl& decl() const { return decl_; }

 private:
    [[nodiscard]] Status make_view();

    Device* device_ = nullptr;
    VkImage image_ = VK_NULL_HANDLE;
    VkDeviceMemory memory_ = VK_NULL_HANDLE;
    VkImageView view_ = VK_NULL_HANDLE;
    ResourceDecl decl_;
    bool adopted_ = false;  // image_ is an embedder's, and memory_ null
};

// Copies before the first frame: waits for its own fence (Device::timeout_ns), so staging is gone when it
// returns. Both need transfer_dst among the target's usages; all that is submitted later to the same queue
// sees the copy. After a time-out the objects in use are left alone, for the device may still read them.
[[nodiscard]] Status upload_buffer(Device& device, const Buffer& target, std::span<const std::byte> bytes);
// `levels`: the mips from 0 on, each with all its layers, tightly packed. Every mip of the image ends in
// shader_read_only (depth: depth_read_only).
[[nodiscard]] Status upload_image(Device& device, const Image& target,
                                  std::span<const std::span<const std::byte>> levels);

// Whose queues may use a resource in turn: one family's, or with CONCURRENT those of all of the device's.
struct Sharing {
    VkSharingMode mode = VK_SHARING_MODE_EXCLUSIVE;
    uint32_t count = 0;
    const uint32_t* families = nullptr;  // the device's own list
};
[[nodiscard]] Sharing concurrent_sharing(const Device& device);  // EXCLUSIVE on a device with one family

template <class CreateInfo>
void share(CreateInfo& info, const Sharing& sharing) {
    info.sharingMode = sharing.mode;
    info.queueFamilyIndexCount = sharing.count;
    info.pQueueFamilyIndices = sharing.families;
}

// Creation info shared by Image and the transient heap, whose images share memory.
[[nodiscard]] VkImageCreateInfo image_create_info(const ResourceDecl& decl);
[[nodiscard]] VkBufferCreateInfo buffer_create_info(const ResourceDecl& decl);

}  // namespace weft::vk
