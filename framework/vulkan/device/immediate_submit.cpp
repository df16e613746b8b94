#include "vulkan/device/immediate_submit.h"

#include "vulkan/device/executor_errors.h"
#include "vulkan/device/handle.h"
#include "vulkan/device/queue_lock.h"

namespace weft::vk {
namespace {

struct ImmediateCommands {
    CommandPoolHandle pool;
    FenceHandle fence;
    VkCommandBuffer commands = VK_NULL_HANDLE;
};

VkResult open(Device& device, ImmediateCommands& immediate) {
    const DeviceFunctions& fn = device.fn();
    VkCommandPoolCreateInfo pool_info{VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO};
    pool_info.flags = VK_COMMAND_POOL_CREATE_TRANSIENT_BIT;
    pool_info.queueFamilyIndex = device.queue().family;
    VkCommandPool pool = VK_NULL_HANDLE;
    VkResult result = fn.vkCreateCommandPool(device.handle(), &pool_info, nullptr, &pool);
    if (result != VK_SUCCESS) return result;
    immediate.pool = {device, pool};
    VkFenceCreateInfo fence_info{VK_STRUCTURE_TYPE_FENCE_CREATE_INFO};
    VkFence fence = VK_NULL_HANDLE;
    result = fn.vkCreateFence(device.handle(), &fence_info, nullptr, &fence);
    if (result != VK_SUCCESS) return result;
    immediate.fence = {device, fence};
    VkCommandBufferAllocateInfo allocate{VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO};
    allocate.commandPool = pool;
    allocate.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
    allocate.commandBufferCount = 1;
    result = fn.vkAllocateCommandBuffers(device.handle(), &allocate, &immediate.commands);
    if (result != VK_SUCCESS) return result;
    VkCommandBufferBeginInfo begin{VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO};
    begin.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
    return fn.vkBeginCommandBuffer(immediate.commands, &begin);
}

VkResult submit_and_wait(Device& device, ImmediateCommands& immediate) {
    const DeviceFunctions& fn = device.fn();
    VkSubmitInfo submit{VK_STRUCTURE_TYPE_SUBMIT_INFO};
    submit.commandBufferCount = 1;
    submit.pCommandBuffers = &immediate.commands;
    const VkResult result = [&] {
        const QueueLock lock(device, device.queue().handle);
        return fn.vkQueueSubmit(device.queue().handle, 1, &submit, immediate.fence.get());
    }();
    if (result != VK_SUCCESS) return result;
    VkFence fence = immediate.fence.get();
    return fn.vkWaitForFences(device.handle(), 1, &fence, VK_TRUE, device.timeout_ns());
}

}  // namespace

Status immediate_submit(Device& device, const std::string& what,
                        const std::function<void(VkCommandBuffer)>& record) {
    ImmediateCommands immediate;
    VkResult result = open(device, immediate);
    if (result == VK_SUCCESS) {
        record(immediate.commands);
        result = device.fn().vkEndCommandBuffer(immediate.commands);
    }
    if (result == VK_SUCCESS) result = submit_and_wait(device, immediate);
    if (result == VK_TIMEOUT) device.abandon();
    if (result != VK_SUCCESS) return failed_call("V418", what, result);
    return Unit{};
}

}  // namespace weft::vk
