// Purpose: connects the validation layers to a MessageCollector. Scope: validation warnings and errors only.
// Performance advice and the loader's notes about missing drivers are not faults of a frame.
#pragma once

#include "vulkan/device/functions.h"
#include "weft/vulkan/messages.h"

namespace weft::vk {

// Used both in the creation of the instance (pNext) and to create the messenger. `collector` must outlive
// both.
[[nodiscard]] VkDebugUtilsMessengerCreateInfoEXT messenger_create_info(MessageCollector& collector);

// Converts a message of the layer. Its pass is the innermost label of the command buffer, or of the queue.
[[nodiscard]] Message message_from(VkDebugUtilsMessageSeverityFlagBitsEXT severity,
                                   const VkDebugUtilsMessengerCallbackDataEXT& data);

}  // namespace weft::vk
