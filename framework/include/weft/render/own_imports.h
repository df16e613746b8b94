// Purpose: the images and buffers of a program that graphs import by name, and the resources of a graph that
// the program uses. Units: pixels, bytes.
#pragma once

#include <vulkan/vulkan_core.h>

#include <array>
#include <cstdint>
#include <map>
#include <string>

#include "weft/imports.h"
#include "weft/vulkan/executor.h"

namespace weft::render {

// The Vulkan object of an import. One of the members is set.
struct ImportObject {
    VkImage image = VK_NULL_HANDLE;
    VkBuffer buffer = VK_NULL_HANDLE;
    // One buffer for each frame slot, for data that the program writes in every frame. In
    // FrameInput::fill_slot, the program writes the buffer of the next frame, while the GPU may still read
    // the other buffer.
    std::array<VkBuffer, vk::kFramesInFlight> slot_buffers{};
    bool operator==(const ImportObject&) const = default;
};
using ImportObjects = std::map<std::string, ImportObject, std::less<>>;

// An import of the program: its description, and its Vulkan object.
struct OwnImport {
    ImportDecl decl;
    ImportObject object;
};

// Returns an image with one mip and one layer. `between` is the state of the image between frames: the
// program uses the image in this way before and after each frame. `between` becomes ImportState::entry and
// ImportState::exit. If these two states differ, change the members of `decl`.
[[nodiscard]] OwnImport own_image(VkImage image, Format format, Extent3D extent, UsageMask usage,
                                  AccessState between);
// Returns a buffer with elements of `stride_bytes`.
[[nodiscard]] OwnImport own_buffer(VkBuffer buffer, uint64_t size_bytes, uint32_t stride_bytes,
                                   UsageMask usage, AccessState between);

// A resource of the graph that the program uses between frames (GraphRequest::exports). One of `image` and
// `buffer` is null. The objects change whenever a new plan begins: after the first frame that follows
// Session::swap_in(), resize() or rebind(), call Session::exported() again. Of a resource with history, the
// object changes in every frame.
struct ExportedResource {
    VkImage image = VK_NULL_HANDLE;
    VkImageView view = VK_NULL_HANDLE;  // A view of the whole image.
    VkBuffer buffer = VK_NULL_HANDLE;
    VkFormat format = VK_FORMAT_UNDEFINED;
    VkExtent3D extent{};
    uint32_t mips = 1;
    uint32_t layers = 1;
    uint64_t size_bytes = 0;  // Only for a buffer.
    // The state at the end of the frame: the writes of the frame are visible to these accesses in these
    // stages.
    VkImageLayout layout = VK_IMAGE_LAYOUT_UNDEFINED;
    VkPipelineStageFlags2 stages = 0;
    VkAccessFlags2 access = 0;
};

}  // namespace weft::render
