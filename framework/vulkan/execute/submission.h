// Purpose: one call of vkQueueSubmit: command buffers, and the semaphores before and after them.
#pragma once

#include <span>
#include <vector>

#include "vulkan/device/handle.h"
#include "weft/vulkan/frame_submit.h"

namespace weft::vk {

class Submission {
 public:
    void add_wait(VkSemaphore semaphore, uint64_t value,
                  VkPipelineStageFlags stages = VK_PIPELINE_STAGE_ALL_COMMANDS_BIT);
    void add_signal(VkSemaphore semaphore, uint64_t value);
    void add(const SemaphoreWait& wait) { add_wait(wait.semaphore, wait.value, wait.stages); }
    void add(const SemaphoreSignal& signal) { add_signal(signal.semaphore, signal.value); }

    // Submits the command buffers. They run after all waits and before all signals. The fence may be null.
    [[nodiscard]] VkResult submit(const Device& device, VkQueue queue,
                                  std::span<const VkCommandBuffer> commands, VkFence fence) const;

 private:
    std::vector<VkSemaphore> waits_, signals_;
    std::vector<uint64_t> wait_values_, signal_values_;
    std::vector<VkPipelineStageFlags> stages_;
};

}  // namespace weft::vk
