// Purpose: buffers and images with their own memory, for data that a plan does not place: scene assets, the
// output, staging. The classes are move-only. Destroy objects while their device exists and no work that uses
// them is pending. Units: bytes. Errors: V407 time-out, V408 device lost, V410 out of memory, V420 sizes do
// not match, V421 the device does not support the image.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "weft/declaration.h"
#include "weft/result.h"
#include "weft/vulkan/device.h"

namespace weft::vk {

// A buffer that may be used on all queues of the device. If these queues are in several families, its sharing
// mode is CONCURRENT.
class Buffer {
 public:
    // Upload and readback memory is mapped and coherent; device memory is not mapped.
    enum class Memory : uint8_t { device, upload, readback };

    [[nodiscard]] static Result<Buffer> create(Device& device, uint64_t size_bytes, VkBufferUsageFlags usage,
                                               Memory memory, const std::string& name);
    Buffer() = default;
    ~Buffer();
    Buffer(Buffer&& other) noexcept;
    Buffer& operator=(Buffer&& other) noexcept;

    [[nodiscard]] VkBuffer handle() const { return buffer_; }
    [[nodiscard]] uint64_t size_bytes() const { return size_bytes_; }
    [[nodiscard]] std::span<std::byte> mapped() const {
        return {memory_.mapped, memory_.mapped != nullptr ? size_bytes_ : 0};
    }

 private:
    Device* device_ = nullptr;
    VkBuffer buffer_ = VK_NULL_HANDLE;
    MemoryBlock memory_;
    uint64_t size_bytes_ = 0;
};

// An image that may be used on all queues of the device. Exception: an import that is not declared concurrent
// belongs to one queue family.
class Image {
 public:
    // Creates an image with the format, extent, mips, layers, samples and usage of `decl`. The view covers
    // the whole image. It is null if the usage allows no view, because the image is only copied.
    [[nodiscard]] static Result<Image> create(Device& device, const ResourceDecl& decl);
    // Wraps an embedder's image, which must be created with image_create_info(decl). The VkImage must outlive
    // this object. This object creates and owns only the view.
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
    MemoryBlock memory_;
    VkImageView view_ = VK_NULL_HANDLE;
    ResourceDecl decl_;
    bool adopted_ = false;  // True: image_ belongs to an embedder, and memory_ is null.
};

// Copies data to a buffer before the first frame; upload_image() does the same for an image. Both functions
// wait for the copy with a fence (Device::timeout_ns()), so that the staging memory is free when they return.
// The usage of the target must include transfer_dst. All later submissions to Device::queue() see the data.
// After a time-out no object is destroyed, because the device may still read it.
[[nodiscard]] Status upload_buffer(Device& device, const Buffer& target, std::span<const std::byte> bytes);
// Copies texels to an image. levels[i] has all layers of mip i, without padding. Afterwards every mip has the
// layout shader_read_only (depth images: depth_read_only).
[[nodiscard]] Status upload_image(Device& device, const Image& target,
                                  std::span<const std::span<const std::byte>> levels);

// The queue families that may use a resource: one family (EXCLUSIVE), or all families from which the device
// has queues (CONCURRENT).
struct Sharing {
    VkSharingMode mode = VK_SHARING_MODE_EXCLUSIVE;
    uint32_t count = 0;  // Number of `families`; 0 if EXCLUSIVE.
    // The numbers of the families. Points into Device::sharing_families(); null if EXCLUSIVE.
    const uint32_t* families = nullptr;
};
// Returns CONCURRENT with all families from which the device has queues; EXCLUSIVE if there is only one.
[[nodiscard]] Sharing concurrent_sharing(const Device& device);

template <class CreateInfo>
void share(CreateInfo& info, const Sharing& sharing) {
    info.sharingMode = sharing.mode;
    info.queueFamilyIndexCount = sharing.count;
    info.pQueueFamilyIndices = sharing.families;
}

// Returns the creation info for an image with this declaration. Class Image uses it, and so does the heap of
// transient images.
[[nodiscard]] VkImageCreateInfo image_create_info(const ResourceDecl& decl);
[[nodiscard]] VkBufferCreateInfo buffer_create_info(const ResourceDecl& decl);

}  // namespace weft::vk
