// Purpose: lets a pass in C++ (weft/pass.h) record Vulkan commands of its own, for example for a user
// interface, an upscaler or the renderer of an engine. The pass declares its ports like every other pass.
// Before the pass, the barriers of the plan bring each port into the state of its declared access. The
// commands must access each port only in this way, and must leave each image in the layout of its port. They
// need no barriers, except between two of their own commands. Afterwards, every state of the command buffer
// may have changed (pipelines, descriptor sets, dynamic state): Weft sets all state that its passes need.
// No render pass may be active when the function `record` of the pass returns.
#pragma once

#include <vulkan/vulkan_core.h>

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "weft/pass.h"

namespace weft::vk {

struct DeviceFunctions;

// The Vulkan objects of one port in the frame that is recorded. Either `image` or `buffer` is null.
struct RawPort {
    std::string_view name;
    bool is_output = false;
    Access access = Access::none;
    VkImage image = VK_NULL_HANDLE;
    // View of the whole range of the port. Null if the access permits no view, because the image is only
    // copied, blitted or cleared. The view lives as long as the plan runs.
    VkImageView view = VK_NULL_HANDLE;
    VkFormat format = VK_FORMAT_UNDEFINED;
    VkExtent3D extent{};  // Extent of the first mip of the range.
    VkSampleCountFlagBits samples = VK_SAMPLE_COUNT_1_BIT;
    VkImageLayout layout = VK_IMAGE_LAYOUT_UNDEFINED;  // The layout before and after the commands.
    VkImageSubresourceRange range{};
    VkBuffer buffer = VK_NULL_HANDLE;
    VkDeviceSize offset_bytes = 0;
    VkDeviceSize size_bytes = 0;
};

// The clear value of an attachment in RawCommands::begin_rendering().
struct RawClear {
    std::string_view port;
    VkClearValue value{};
};

// The place where a pass records its commands. It is valid until the function `record` of the pass returns.
struct RawCommands {
    VkCommandBuffer commands = VK_NULL_HANDLE;  // In recording state; no render pass is active.
    VkPhysicalDevice physical = VK_NULL_HANDLE;
    VkDevice device = VK_NULL_HANDLE;
    uint32_t queue_family = 0;
    // Less than kFramesInFlight. When this pass records a frame, the last frame with the same slot has
    // finished, so that the pass may destroy or overwrite its own objects of that frame.
    uint32_t frame_slot = 0;
    uint64_t frame_index = 0;
    const HostInputs* host = nullptr;     // The values of the program for this frame; never null.
    std::span<const RawPort> ports;       // In the order of PassType::ports.
    const DeviceFunctions* fn = nullptr;  // The functions that begin_rendering() calls.

    // Both functions assert that the pass type declares the port.
    [[nodiscard]] const RawPort& in(std::string_view port) const;
    [[nodiscard]] const RawPort& out(std::string_view port) const;

    // Begins dynamic rendering (vkCmdBeginRendering) to all ports that are attachments. The colour
    // attachments have the order of PassType::ports. The access of a port chooses the load operation:
    // color_read_write, depth_read_write and depth_read load the old content. A port with color_write is
    // cleared if `clears` names it; otherwise its old content is undefined, and the pass must draw to every
    // texel. A port with depth_write is cleared to the value in `clears`, or to 0. All writes are stored.
    // Viewport and scissor are not set. A pass may also begin a render pass of its own instead
    // (VkRenderPass): its attachments then must have RawPort::layout as initial and final layout.
    void begin_rendering(std::span<const RawClear> clears = {}) const;
    void end_rendering() const;
};

// Returns the commands of the pass that is recorded. Call this only in the function `record` of a pass type,
// with the Recorder that the function got from the Vulkan executor.
[[nodiscard]] const RawCommands& raw_commands(Recorder& recorder);

}  // namespace weft::vk
