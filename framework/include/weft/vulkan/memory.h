// Purpose: buffers and images with their own memory, for data outside a plan's transient heap: scene assets,
// the output, staging. Move-only; they must be destroyed while their device exists and no work on them is
// pending. Units: bytes. Errors: V407 time-out, V408 device lost, V410 out of memory, V420 sizes do not
// match, V421 the device does not support the image.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "weft/declaration.h"
#include "weft/result.h"
#include "weft/vulkan/device.h"

namespace weft::vk {

// Shared by all families in which the device has queues.
class Buffer {
 public:
    enum class Memory : uint8_t {
        device,
        upload,
        readback
    };  // upload and readback memory is mapped and
        // coherent

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

// Shared by all families in which the device has queues; an import that is not declared concurrent belongs to
// one family.
class Image {
 public:
    // Format, extent, mips, layers, samples and usage are those of `decl`. The view covers the whole image;
    // it is null if no usage allows a view (only copied).
    [[nodiscard]] static Result<Image> create(Device& device, const ResourceDecl& decl);
    // An embedder's image, created with image_create_info(decl). It must outlive this object, which owns only
    // the view.
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
    bool adopted_ = false;  // true: image_ belongs to an embedder, and memory_ is null
};

// Copies data before the first frame. Waits for its own fence (Device::timeout_ns), so the staging memory is
// freed on return. Both require transfer_dst in the target's usage. The copy is visible to all later
// submissions to the same queue. After a time-out, objects in use are not destroyed, because the device may
// still read them.
[[nodiscard]] Status upload_buffer(Device& device, const Buffer& target, std::span<const std::byte> bytes);
// `levels`: the mips from 0 on, each with all its layers, tightly packed. Every mip of the image ends in
// shader_read_only (depth: depth_read_only).
[[nodiscard]] Status upload_image(Device& device, const Image& target,
                                  std::span<const std::span<const std::byte>> levels);

// The queue families that may use a resource: one, or with CONCURRENT all families of the device.
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

// Creation info used by Image and by the transient heap, whose images share memory.
[[nodiscard]] VkImageCreateInfo image_create_info(const ResourceDecl& decl);
[[nodiscard]] VkBufferCreateInfo buffer_create_info(const ResourceDecl& decl);

}  // namespace weft::vk
