#include "vulkan/execute/submission.h"

#include "vulkan/device/functions.h"
#include "vulkan/device/queue_lock.h"

namespace weft::vk {

void Submission::add_wait(VkSemaphore semaphore, uint64_t value, VkPipelineStageFlags stages) {
    waits_.push_back(semaphore);
    wait_values_.push_back(value);
    stages_.push_back(stages);
}

void Submission::add_signal(VkSemaphore semaphore, uint64_t value) {
    signals_.push_back(semaphore);
    signal_values_.push_back(value);
}

// Calls vkQueueSubmit instead of vkQueueSubmit2, because the validation layer of Vulkan 1.3.239 tracks
// hazards between submissions only for vkQueueSubmit.
VkResult Submission::submit(const Device& device, VkQueue queue, std::span<const VkCommandBuffer> commands,
                            VkFence fence) const {
    VkTimelineSemaphoreSubmitInfo timeline{VK_STRUCTURE_TYPE_TIMELINE_SEMAPHORE_SUBMIT_INFO};
    timeline.waitSemaphoreValueCount = static_cast<uint32_t>(wait_values_.size());
    timeline.pWaitSemaphoreValues = wait_values_.data();
    timeline.signalSemaphoreValueCount = static_cast<uint32_t>(signal_values_.size());
    timeline.pSignalSemaphoreValues = signal_values_.data();
    VkSubmitInfo info{VK_STRUCTURE_TYPE_SUBMIT_INFO};
    if (!waits_.empty() || !signals_.empty()) info.pNext = &timeline;
    info.commandBufferCount = static_cast<uint32_t>(commands.size());
    info.pCommandBuffers = commands.data();
    info.waitSemaphoreCount = static_cast<uint32_t>(waits_.size());
    info.pWaitSemaphores = waits_.data();
    info.pWaitDstStageMask = stages_.data();
    info.signalSemaphoreCount = static_cast<uint32_t>(signals_.size());
    info.pSignalSemaphores = signals_.data();
    const QueueLock lock(device, queue);
    return device.fn().vkQueueSubmit(queue, 1, &info, fence);
}

}  // namespace weft::vk
