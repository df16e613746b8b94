#include "weft/vulkan/memory.h"
#include "graph/diagnostics/make_error.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <utility>

#include "vulkan/device/device_memory.h"
#include "vulkan/device/functions.h"
#include "vulkan/device/to_vk.h"
#include "vulkan/device/vk_result.h"
#include "vulkan/memory/buffer_demand.h"
#include "weft/vulkan/native.h"

namespace weft::vk {
namespace {

VkMemoryPropertyFlags wanted_properties(Buffer::Memory memory) {
    switch (memory) {
        case Buffer::Memory::device:
            return VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT;
        case Buffer::Memory::upload:
            return VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
        case Buffer::Memory::readback:
            return VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT |
                   VK_MEMORY_PROPERTY_HOST_CACHED_BIT;
    }
    return 0;
}

// Returns a memory type with the properties `wanted`. If the device has none, the function
// searches again without the properties host-cached and device-local, because memory without them works too.
uint32_t pick_memory_type(const Device& device, uint32_t type_bits, VkMemoryPropertyFlags wanted) {
    const uint32_t type = device.memory_type(type_bits, wanted);
    if (type != UINT32_MAX) return type;
    constexpr VkMemoryPropertyFlags wishes =
        VK_MEMORY_PROPERTY_HOST_CACHED_BIT | VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT;
    return device.memory_type(type_bits, wanted & ~wishes);
}

Result<MemoryBlock> allocate(Device& device, const VkMemoryRequirements& needs, VkMemoryPropertyFlags wanted,
                             bool mapped, const std::string& name, MemoryContent content) {
    const std::string what = "allocating " + std::to_string(needs.size) + " bytes for \"" + name + "\"";
    const uint32_t type = pick_memory_type(device, needs.memoryTypeBits, wanted);
    if (type == UINT32_MAX) return vk_error(VK_ERROR_OUT_OF_DEVICE_MEMORY, what);
    MemoryBlock block;
    const VkResult result =
        allocate_memory(device, {needs.size, needs.alignment, type, mapped, name, content}, block);
    if (result != VK_SUCCESS) return vk_error(result, what);
    return block;
}

// Returns the number of mip levels from the full size down to one texel. Vulkan also reports a
// limit (maxMipLevels), but for the largest image of a format. A smaller image has room for fewer mip levels.
uint32_t mips_of(const VkExtent3D& extent) {
    const uint32_t largest = std::max({extent.width, extent.height, extent.depth});
    return static_cast<uint32_t>(std::bit_width(largest));
}

Status check_supported(const Device& device, const VkImageCreateInfo& info, const ResourceDecl& decl) {
    VkImageFormatProperties limits{};
    const VkResult result = device.instance_fn().vkGetPhysicalDeviceImageFormatProperties(
        device.physical(), info.format, info.imageType, info.tiling, info.usage, info.flags, &limits);
    const bool fits =
        result == VK_SUCCESS && info.usage != 0 && info.extent.width <= limits.maxExtent.width &&
        info.extent.height <= limits.maxExtent.height && info.extent.depth <= limits.maxExtent.depth &&
        info.mipLevels <= mips_of(info.extent) && info.mipLevels <= limits.maxMipLevels &&
        info.arrayLayers <= limits.maxArrayLayers && (limits.sampleCounts & info.samples) != 0;
    if (fits) return Unit{};
    return make_error(
        "V421",
        "the device \"" + device.info().name + "\" does not support the image \"" + decl.name +
            "\": " + std::string(format_info(decl.format).name) + ", " + std::to_string(info.extent.width) +
            "x" + std::to_string(info.extent.height) + "x" + std::to_string(info.extent.depth) + ", " +
            std::to_string(info.mipLevels) + " mips, " + std::to_string(info.arrayLayers) + " layers, " +
            std::to_string(decl.samples) + " samples",
        {"use a smaller size or another format; `weft doctor --json` lists the limits and formats of the "
         "device"});
}

// Returns the usage that a resource needs in addition to the usages of its passes. A persistent resource is
// cleared before the first frame, so it must be a transfer destination. Other resources need nothing.
UsageMask before_first_frame(const ResourceDecl& decl) {
    return decl.lifetime == ResourceLifetime::persistent ? usage::kTransferDst : 0;
}

// The usages that permit an image view. An image with none of them gets no view.
constexpr UsageMask kViewUsages =
    usage::kSampled | usage::kStorage | usage::kColorAttachment | usage::kDepthAttachment;

Result<VkImageView> whole_view(Device& device, VkImage image, const ResourceDecl& decl) {
    VkImageViewCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO;
    info.image = image;
    info.viewType = view_type_to_vk(decl.image_kind);
    info.format = to_vk(decl.format);
    info.subresourceRange = to_vk(decl.whole());
    VkImageView view = VK_NULL_HANDLE;
    const VkResult result = device.fn().vkCreateImageView(device.handle(), &info, nullptr, &view);
    if (result != VK_SUCCESS) return vk_error(result, "creating a view of \"" + decl.name + "\"");
    device.name(VK_OBJECT_TYPE_IMAGE_VIEW, object_id(view), decl.name);
    return view;
}

}  // namespace

Sharing concurrent_sharing(const Device& device) {
    const std::vector<uint32_t>& families = device.sharing_families();
    if (families.empty()) return {};
    return {VK_SHARING_MODE_CONCURRENT, static_cast<uint32_t>(families.size()), families.data()};
}

VkBufferCreateInfo buffer_create_info(const ResourceDecl& decl) {
    assert(decl.kind == ResourceKind::buffer);
    VkBufferCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO;
    info.size = decl.size_bytes;
    info.usage = buffer_usage_to_vk(decl.usage | before_first_frame(decl));
    info.sharingMode = VK_SHARING_MODE_EXCLUSIVE;
    return info;
}

VkImageCreateInfo image_create_info(const ResourceDecl& decl) {
    assert(decl.kind == ResourceKind::image);
    VkImageCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO;
    if (decl.image_kind == ImageKind::cube || decl.image_kind == ImageKind::cube_array) {
        info.flags |= VK_IMAGE_CREATE_CUBE_COMPATIBLE_BIT;
    }
    // The flag VK_IMAGE_CREATE_ALIAS_BIT is never set. It promises that images in the same memory share their
    // texels, but in Weft a resource that takes over memory always starts with undefined content. With the
    // flag, the validation layer would also treat equal images at the same place as one image. It would then
    // ignore the barriers of a third resource that used the memory in between.
    info.imageType = image_type_to_vk(decl.image_kind);
    info.format = to_vk(decl.format);
    info.extent = to_vk(decl.extent);
    info.mipLevels = decl.mips;
    info.arrayLayers = decl.layers;
    info.samples = samples_to_vk(decl.samples);
    info.tiling = VK_IMAGE_TILING_OPTIMAL;
    info.usage = image_usage_to_vk(decl.usage | before_first_frame(decl));
    // Weft samples depth images in a read-only depth layout, and Vulkan allows that layout only for images
    // with the attachment usage.
    if ((decl.aspects & aspect::kColor) == 0) info.usage |= VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT;
    info.sharingMode = VK_SHARING_MODE_EXCLUSIVE;
    info.initialLayout = VK_IMAGE_LAYOUT_UNDEFINED;
    return info;
}

BufferDemand buffer_demand(Device& device, uint64_t size_bytes, VkBufferUsageFlags usage,
                           Buffer::Memory memory) {
    VkBufferCreateInfo info{VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO};
    info.size = size_bytes;
    info.usage = usage;
    share(info, concurrent_sharing(device));
    VkDeviceBufferMemoryRequirements query{VK_STRUCTURE_TYPE_DEVICE_BUFFER_MEMORY_REQUIREMENTS};
    query.pCreateInfo = &info;
    VkMemoryRequirements2 needs{VK_STRUCTURE_TYPE_MEMORY_REQUIREMENTS_2};
    device.fn().vkGetDeviceBufferMemoryRequirements(device.handle(), &query, &needs);
    return {needs.memoryRequirements.size,
            pick_memory_type(device, needs.memoryRequirements.memoryTypeBits, wanted_properties(memory))};
}

Result<Buffer> Buffer::create(Device& device, uint64_t size_bytes, VkBufferUsageFlags usage, Memory memory,
                              const std::string& name) {
    assert(size_bytes > 0 && usage != 0);
    // If a later step fails, the destructor of this incomplete buffer frees what has been created.
    Buffer buffer;
    buffer.device_ = &device;
    buffer.size_bytes_ = size_bytes;
    VkBufferCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO;
    info.size = size_bytes;
    info.usage = usage;
    share(info, concurrent_sharing(device));
    const DeviceFunctions& fn = device.fn();
    VkResult result = fn.vkCreateBuffer(device.handle(), &info, nullptr, &buffer.buffer_);
    if (result != VK_SUCCESS) return vk_error(result, "creating buffer \"" + name + "\"");
    device.name(VK_OBJECT_TYPE_BUFFER, object_id(buffer.buffer_), name);

    VkMemoryRequirements needs{};
    fn.vkGetBufferMemoryRequirements(device.handle(), buffer.buffer_, &needs);
    Result<MemoryBlock> allocated = allocate(device, needs, wanted_properties(memory),
                                             memory != Memory::device, name, MemoryContent::buffers);
    if (!allocated) return allocated.take_errors();
    buffer.memory_ = *allocated;
    result = fn.vkBindBufferMemory(device.handle(), buffer.buffer_, buffer.memory_.memory,
                                   buffer.memory_.offset_bytes);
    if (result != VK_SUCCESS) return vk_error(result, "binding memory of \"" + name + "\"");
    return buffer;
}

Buffer::~Buffer() {
    if (device_ == nullptr || device_->abandoned()) return;
    device_->fn().vkDestroyBuffer(device_->handle(), buffer_, nullptr);
    free_memory(*device_, memory_);
}

Buffer::Buffer(Buffer&& other) noexcept {
    *this = std::move(other);
}

Buffer& Buffer::operator=(Buffer&& other) noexcept {
    std::swap(device_, other.device_);
    std::swap(buffer_, other.buffer_);
    std::swap(memory_, other.memory_);
    std::swap(size_bytes_, other.size_bytes_);
    return *this;
}

Result<Image> Image::create(Device& device, const ResourceDecl& decl) {
    VkImageCreateInfo info = image_create_info(decl);
    if (!decl.import || decl.import->concurrent) share(info, concurrent_sharing(device));
    if (Status supported = check_supported(device, info, decl); !supported) return supported.take_errors();
    // If a later step fails, the destructor of this incomplete image frees what has been created.
    Image image;
    image.device_ = &device;
    image.decl_ = decl;
    const DeviceFunctions& fn = device.fn();
    VkResult result = fn.vkCreateImage(device.handle(), &info, nullptr, &image.image_);
    if (result != VK_SUCCESS) return vk_error(result, "creating image \"" + decl.name + "\"");
    device.name(VK_OBJECT_TYPE_IMAGE, object_id(image.image_), decl.name);

    VkMemoryRequirements needs{};
    fn.vkGetImageMemoryRequirements(device.handle(), image.image_, &needs);
    Result<MemoryBlock> allocated =
        allocate(device, needs, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT, false, decl.name, MemoryContent::images);
    if (!allocated) return allocated.take_errors();
    image.memory_ = *allocated;
    result =
        fn.vkBindImageMemory(device.handle(), image.image_, image.memory_.memory, image.memory_.offset_bytes);
    if (result != VK_SUCCESS) return vk_error(result, "binding memory of \"" + decl.name + "\"");

    if (Status made = image.make_view(); !made) return made.take_errors();
    return image;
}

Result<Image> Image::adopt(Device& device, VkImage own, const ResourceDecl& decl) {
    Image image;
    image.device_ = &device;
    image.decl_ = decl;
    image.image_ = own;
    image.adopted_ = true;
    if (Status made = image.make_view(); !made) return made.take_errors();
    return image;
}

Status Image::make_view() {
    if ((decl_.usage & kViewUsages) == 0) return Unit{};
    Result<VkImageView> view = whole_view(*device_, image_, decl_);
    if (!view) return view.take_errors();
    view_ = *view;
    return Unit{};
}

Image::~Image() {
    if (device_ == nullptr || device_->abandoned()) return;
    device_->fn().vkDestroyImageView(device_->handle(), view_, nullptr);
    if (adopted_) return;
    device_->fn().vkDestroyImage(device_->handle(), image_, nullptr);
    free_memory(*device_, memory_);
}

Image::Image(Image&& other) noexcept {
    *this = std::move(other);
}

Image& Image::operator=(Image&& other) noexcept {
    std::swap(device_, other.device_);
    std::swap(image_, other.image_);
    std::swap(memory_, other.memory_);
    std::swap(view_, other.view_);
    std::swap(decl_, other.decl_);
    std::swap(adopted_, other.adopted_);
    return *this;
}

}  // namespace weft::vk
