// Purpose: commands that are recorded and submitted once, with a fence that tells when they have finished.
#pragma once

#include "vulkan/device/handle.h"

namespace weft::vk {

// A command buffer for the main queue, with a pool of its own. Before open() it is empty.
struct OneTimeCommands {
    CommandPoolHandle pool;
    FenceHandle fence;
    VkCommandBuffer commands = VK_NULL_HANDLE;

    // Creates the objects and begins the recording.
    [[nodiscard]] VkResult open(Device& device);
    // Submits the recorded commands to the main queue. The fence is signalled when they have finished.
    [[nodiscard]] VkResult submit(Device& device) const;
    // Waits for the fence, at most Device::timeout_ns().
    [[nodiscard]] VkResult wait(Device& device) const;
};

}  // namespace weft::vk
