// Purpose: access to the native Vulkan objects, for embedders that also draw themselves; nothing else exposes
// them. Embedders must restore layouts, pending accesses and ownership. For the other direction, see
// Device::adopt() and enable_features().
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

// Data that an embedder needs to sample, copy or present an image exported by a graph.
struct NativeImage {
    VkImage image = VK_NULL_HANDLE;
    VkImageView view = VK_NULL_HANDLE;  // null for an image that is only copied
    VkFormat format = VK_FORMAT_UNDEFINED;
    VkExtent3D extent{};
    VkImageLayout layout = VK_IMAGE_LAYOUT_UNDEFINED;  // between two frames: its declared exit layout
};

[[nodiscard]] NativeDevice native(const Device& device);
[[nodiscard]] NativeImage native(const Image& image);

// A handle in the form that Device::name() expects.
template <class Handle>
[[nodiscard]] uint64_t object_id(Handle handle) {
    static_assert(std::is_pointer_v<Handle> && sizeof(Handle) == sizeof(uint64_t));
    return reinterpret_cast<uint64_t>(handle);
}

}  // namespace weft::vk
