// Purpose: the escape hatch. An embedder that draws beside Weft reaches the Vulkan objects here, and only
// here; what it does with them it must leave as it found them: layouts, pending accesses, ownership. To bring
// objects the other way: Device::adopt() and enable_features().
#pragma once

#include <cstdint>
#include <type_traits>

#include "weft/vulkan/device.h"
#include "weft/vulkan/memory.h"

namespace weft::vk {

struct NativeDevice {
    VkInstance instance = VK_NULL_HANDLE;
    VkPhysicalDevice physical = VK_NULL_HANDLE;
    VkDevice device = VK_NULL_HANDLE;
    Queue queue;
};

// What an embedder needs to sample, copy or present an image that a graph exports.
struct NativeImage {
    VkImage image = VK_NULL_HANDLE;
    VkImageView view = VK_NULL_HANDLE;  // null for an image that is only copied
    VkFormat format = VK_FORMAT_UNDEFINED;
    VkExtent3D extent{};
    VkImageLayout layout = VK_IMAGE_LAYOUT_UNDEFINED;  // between two frames: its declared exit layout
};

[[nodiscard]] NativeDevice native(const Device& device);
[[nodiscard]] NativeImage native(const Image& image);

// A handle as Device::name() wants it.
template <class Handle>
[[nodiscard]] uint64_t object_id(Handle handle) {
    static_assert(std::is_pointer_v<Handle> && sizeof(Handle) == sizeof(uint64_t));
    return reinterpret_cast<uint64_t>(handle);
}

}  // namespace weft::vk
