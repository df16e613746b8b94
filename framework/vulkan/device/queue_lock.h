// Purpose: calls the program's functions before and after the use of a queue, so that other threads of the
// program do not use the queue at the same time. Create a QueueLock for each vkQueueSubmit() and
// vkQueueWaitIdle().
#pragma once

#include "weft/vulkan/device.h"

namespace weft::vk {

class QueueLock {
 public:
    QueueLock(const Device& device, VkQueue queue) : callbacks_(device.callbacks()), queue_(queue) {
        if (callbacks_.lock_queue) callbacks_.lock_queue(queue_);
    }
    ~QueueLock() {
        if (callbacks_.unlock_queue) callbacks_.unlock_queue(queue_);
    }
    QueueLock(const QueueLock&) = delete;
    QueueLock& operator=(const QueueLock&) = delete;

 private:
    const EmbedderCallbacks& callbacks_;
    VkQueue queue_;
};

}  // namespace weft::vk
