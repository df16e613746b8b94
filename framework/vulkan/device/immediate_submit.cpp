#include "vulkan/device/immediate_submit.h"

#include "vulkan/device/executor_errors.h"
#include "vulkan/device/one_time_commands.h"

namespace weft::vk {

Status immediate_submit(Device& device, const std::string& what,
                        const std::function<void(VkCommandBuffer)>& record) {
    OneTimeCommands once;
    VkResult result = once.open(device);
    if (result == VK_SUCCESS) {
        record(once.commands);
        result = device.fn().vkEndCommandBuffer(once.commands);
    }
    if (result == VK_SUCCESS) result = once.submit(device);
    if (result == VK_SUCCESS) result = once.wait(device);
    if (result == VK_TIMEOUT) device.abandon();
    if (result != VK_SUCCESS) return failed_call("V418", what, result);
    return Unit{};
}

}  // namespace weft::vk
