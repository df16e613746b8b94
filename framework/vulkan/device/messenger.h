// Purpose: connects the validation layers to a MessageCollector. Only validation warnings and errors are
// collected. Performance advice and the loader's notes about missing drivers are left out, because they are
// not errors of a frame.
#pragma once

#include "vulkan/device/functions.h"
#include "weft/vulkan/messages.h"

namespace weft::vk {

// Returns the create info for a messenger that adds messages to `collector`. The same info is used in
// VkInstanceCreateInfo::pNext and to create the messenger. `collector` must outlive the instance and the
// messenger.
[[nodiscard]] VkDebugUtilsMessengerCreateInfoEXT messenger_create_info(MessageCollector& collector);

// Converts a message of the validation layer. The message names a pass: the innermost label of the command
// buffer or, if the command buffer has no label, of the queue.
[[nodiscard]] Message message_from(VkDebugUtilsMessageSeverityFlagBitsEXT severity,
                                   const VkDebugUtilsMessengerCallbackDataEXT& data);

}  // namespace weft::vk
