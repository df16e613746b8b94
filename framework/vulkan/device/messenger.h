// Purpose: ties the validation layers to a MessageCollector.
// Scope: validation messages only, warnings and errors. Performance advice and the loader's own notes about
// drivers that this machine lacks are not faults of a frame.
#pragma once

#include "weft/vulkan/functions.h"
#include "weft/vulkan/messages.h"

namespace weft::vk {

// To be chained to instance creation, and to create the lasting messenger from. `collector` must outlive
// both.
[[nodiscard]] VkDebugUtilsMessengerCreateInfoEXT messenger_create_info(MessageCollector& collector);

// As the layer delivers it; the pass is the innermost label of the command buffer, or of the queue.
[[nodiscard]] Message message_from(VkDebugUtilsMessageSeverityFlagBitsEXT severity,
                                   const VkDebugUtilsMessengerCallbackDataEXT& data);

}  // namespace weft::vk
