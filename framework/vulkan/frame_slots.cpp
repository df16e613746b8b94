#include "vulkan/frame_slots.h"

#include "vulkan/executor_errors.h"

namespace weft::vk {

VkResult FrameSlots::open(Device& device, Slot& slot) {
    const DeviceFunctions& fn = device.fn();
    VkCommandPoolCreateInfo pool_info{VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO};
    pool_info.queueFamilyIndex = device.queue().family;
    VkCommandPool pool = VK_NULL_HANDLE;
    VkResult result = fn.vkCreateCommandPool(device.handle(), &pool_info, nullptr, &pool);
    if (result != VK_SUCCESS) return result;
    slot.pool = {device, pool};
    VkFenceCreateInfo fence_info{VK_STRUCTURE_TYPE_FENCE_CREATE_INFO};
    VkFence fence = VK_NULL_HANDLE;
    result = fn.vkCreateFence(device.handle(), &fence_info, nullptr, &fence);
    if (result != VK_SUCCESS) return result;
    slot.fence = {device, fence};
    VkCommandBufferAllocateInfo info{VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO};
    info.commandPool = pool;
    info.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
    info.commandBufferCount = 1;
    return fn.vkAllocateCommandBuffers(device.handle(), &info, &slot.commands);
}

Result<FrameSlots> FrameSlots::create(Device& device) {
    FrameSlots slots;
    slots.device_ = &device;
    for (Slot& slot : slots.slots_)
        if (const VkResult result = open(device, slot); result != VK_SUCCESS)
            return failed_call("V418", "making a frame slot", result);
    return slots;
}

VkResult FrameSlots::wait(uint32_t slot) {
    if (!slots_[slot].in_flight) return VK_SUCCESS;
    VkFence fence = slots_[slot].fence.get();
    VkResult result =
        device_->fn().vkWaitForFences(device_->handle(), 1, &fence, VK_TRUE, device_->timeout_ns());
    if (result != VK_SUCCESS) return result;
    slots_[slot].in_flight = false;
    return device_->fn().vkResetFences(device_->handle(), 1, &fence);
}

bool FrameSlots::is_over(uint32_t slot) const {
    if (!slots_[slot].in_flight) return true;
    const VkResult result = device_->fn().vkGetFenceStatus(device_->handle(), slots_[slot].fence.get());
    return result == VK_SUCCESS || result == VK_ERROR_DEVICE_LOST;
}

Result<VkCommandBuffer> FrameSlots::begin(uint32_t slot) {
    const Slot& frame = slots_[slot];
    VkResult result = device_->fn().vkResetCommandPool(device_->handle(), frame.pool.get(), 0);
    VkCommandBufferBeginInfo info{VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO};
    info.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
    if (result == VK_SUCCESS) result = device_->fn().vkBeginCommandBuffer(frame.commands, &info);
    if (result != VK_SUCCESS) return failed_call("V418", "beginning a frame's commands", result);
    return frame.commands;
}

VkResult FrameSlots::submit(uint32_t slot) {
    Slot& frame = slots_[slot];
    VkResult result = device_->fn().vkEndCommandBuffer(frame.commands);
    if (result != VK_SUCCESS) return result;
    // Not vkQueueSubmit2: the validation layer of Vulkan 1.3.239 tracks hazards between submissions only for
    // this one, and one queue with fences needs no more.
    VkSubmitInfo info{VK_STRUCTURE_TYPE_SUBMIT_INFO};
    info.commandBufferCount = 1;
    info.pCommandBuffers = &frame.commands;
    result = device_->fn().vkQueueSubmit(device_->queue().handle, 1, &info, frame.fence.get());
    frame.in_flight = result == VK_SUCCESS;
    return result;
}

}  // namespace weft::vk
