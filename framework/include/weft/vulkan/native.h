// Purpose: gives Weft's Vulkan objects to embedders that also record commands of their own. An embedder may
// use an image or buffer between two frames. Before the next frame, the embedder must return the object to
// the state that Weft expects (for an import: ImportState::entry). The state is the layout, the accesses that
// may still be pending, and the queue family that owns the object. To let Weft use an embedder's objects, see
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

// The handles and properties of an image, usually one that a graph imports as its output. An embedder needs
// them to sample, copy or present the image.
struct NativeImage {
    VkImage image = VK_NULL_HANDLE;
    VkImageView view = VK_NULL_HANDLE;  // View of the whole image; null for an image that is only copied.
    VkFormat format = VK_FORMAT_UNDEFINED;
    VkExtent3D extent{};
    // Layout of the image between two frames: for an import the declared exit layout, otherwise UNDEFINED.
    VkImageLayout layout = VK_IMAGE_LAYOUT_UNDEFINED;
};

[[nodiscard]] NativeDevice native(const Device& device);
[[nodiscard]] NativeImage native(const Image& image);

// Converts a handle to the number that Device::name() expects.
template <class Handle>
[[nodiscard]] uint64_t object_id(Handle handle) {
    static_assert(std::is_pointer_v<Handle> && sizeof(Handle) == sizeof(uint64_t));
    return reinterpret_cast<uint64_t>(handle);
}

}  // namespace weft::vk
