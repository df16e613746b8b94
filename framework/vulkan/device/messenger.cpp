#include "vulkan/device/messenger.h"

namespace weft::vk {
namespace {

std::string text_or_empty(const char* text) {
    return text == nullptr ? std::string{} : std::string{text};
}

VKAPI_ATTR VkBool32 VKAPI_CALL on_message(VkDebugUtilsMessageSeverityFlagBitsEXT severity,
                                          VkDebugUtilsMessageTypeFlagsEXT /*types*/,
                                          const VkDebugUtilsMessengerCallbackDataEXT* data, void* user) {
    static_cast<MessageCollector*>(user)->add(message_from(severity, *data));
    // VK_FALSE lets the Vulkan call that caused the message continue as it would without the layer.
    return VK_FALSE;
}

}  // namespace

Message message_from(VkDebugUtilsMessageSeverityFlagBitsEXT severity,
                     const VkDebugUtilsMessengerCallbackDataEXT& data) {
    Message message;
    message.severity = severity >= VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT ? MessageSeverity::error
                       : severity >= VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT
                           ? MessageSeverity::warning
                           : MessageSeverity::info;
    message.id = text_or_empty(data.pMessageIdName);
    message.text = text_or_empty(data.pMessage);
    // The layer lists the most recent label first, so element 0 is the innermost label: the pass.
    if (data.cmdBufLabelCount > 0) {
        message.pass = text_or_empty(data.pCmdBufLabels[0].pLabelName);
    } else if (data.queueLabelCount > 0) {
        message.pass = text_or_empty(data.pQueueLabels[0].pLabelName);
    }
    return message;
}

VkDebugUtilsMessengerCreateInfoEXT messenger_create_info(MessageCollector& collector) {
    VkDebugUtilsMessengerCreateInfoEXT info{};
    info.sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT;
    info.messageSeverity =
        VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT;
    info.messageType = VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT;
    info.pfnUserCallback = on_message;
    info.pUserData = &collector;
    return info;
}

}  // namespace weft::vk
