#include "vulkan/device/one_time_commands.h"

#include "vulkan/device/queue_lock.h"

namespace weft::vk {

VkResult OneTimeCommands::open(Device& device) {
    const DeviceFunctions& fn = device.fn();
    VkCommandPoolCreateInfo pool_info{VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO};
    pool_info.flags = VK_COMMAND_POOL_CREATE_TRANSIENT_BIT;
    pool_info.queueFamilyIndex = device.queue().family;
    VkCommandPool new_pool = VK_NULL_HANDLE;
    VkResult result = fn.vkCreateCommandPool(device.handle(), &pool_info, nullptr, &new_pool);
    if (result != VK_SUCCESS) return result;
    pool = {device, new_pool};
    VkFenceCreateInfo fence_info{VK_STRUCTURE_TYPE_FENCE_CREATE_INFO};
    VkFence new_fence = VK_NULL_HANDLE;
    result = fn.vkCreateFence(device.handle(), &fence_info, nullptr, &new_fence);
    if (result != VK_SUCCESS) return result;
    fence = {device, new_fence};
    VkCommandBufferAllocateInfo allocate{VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO};
    allocate.commandPool = new_pool;
    allocate.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
    allocate.commandBufferCount = 1;
    result = fn.vkAllocateCommandBuffers(device.handle(), &allocate, &commands);
    if (result != VK_SUCCESS) return result;
    VkCommandBufferBeginInfo begin{VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO};
    begin.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
    return fn.vkBeginCommandBuffer(commands, &begin);
}

VkResult OneTimeCommands::submit(Device& device) const {
    VkSubmitInfo submit{VK_STRUCTURE_TYPE_SUBMIT_INFO};
    submit.commandBufferCount = 1;
    submit.pCommandBuffers = &commands;
    const QueueLock lock(device, device.queue().handle);
    return device.fn().vkQueueSubmit(device.queue().handle, 1, &submit, fence.get());
}

VkResult OneTimeCommands::wait(Device& device) const {
    VkFence signalled = fence.get();
    return device.fn().vkWaitForFences(device.handle(), 1, &signalled, VK_TRUE, device.timeout_ns());
}

}  // namespace weft::vk
