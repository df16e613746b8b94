// Purpose: the timeline semaphores of a plan, one a logical queue: what every batch waits for and signals, as
// numbers. A plan of one batch needs none. Frames count from 0. Errors: V418.
#pragma once

#include <vector>

#include "weft/plan.h"
#include "weft/result.h"
#include "weft/vulkan/handle.h"

namespace weft::vk {

// A point on one queue's timeline.
struct TimelinePoint {
    VkSemaphore semaphore = VK_NULL_HANDLE;
    uint64_t value = 0;
};

class QueueTimelines {
 public:
    [[nodiscard]] static Result<QueueTimelines> create(Device& device, const FramePlan& plan);

    [[nodiscard]] bool in_use() const { return !semaphores_.empty(); }
    [[nodiscard]] TimelinePoint end_of(uint32_t batch, uint64_t frame) const;
    // The ends of other batches, of this frame or the one before. In the first frame everything also comes
    // after what the first queue did before it: the prologue, and the uploads of whoever made the imports.
    [[nodiscard]] std::vector<TimelinePoint> waits_of(uint32_t batch, uint64_t frame) const;
    // What the first queue signals before the first frame.
    [[nodiscard]] TimelinePoint ready() const { return {ready_.get(), 1}; }

 private:
    struct BatchPlace {
        QueueIndex queue = 0;
        uint64_t rank = 0;  // among the batches of its queue
        std::vector<QueueWait> waits;
    };
    std::vector<SemaphoreHandle> semaphores_;  // by queue
    std::vector<BatchPlace> batches_;
    std::vector<uint64_t> counts_;  // batches by queue
    SemaphoreHandle ready_;
};

}  // namespace weft::vk
