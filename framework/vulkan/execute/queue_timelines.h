// Purpose: the timeline semaphores of a plan, one per logical queue, and the values that each batch waits for
// and signals. A plan with one batch needs none. Frames count from 0. Errors: V418.
#pragma once

#include <vector>

#include "vulkan/device/handle.h"
#include "weft/plan.h"
#include "weft/result.h"

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
    // The ends of other batches, of this frame or the previous one. The first frame also waits for everything
    // that the first queue did before: the prologue, and uploads to imports.
    [[nodiscard]] std::vector<TimelinePoint> waits_of(uint32_t batch, uint64_t frame) const;
    // The point that the first queue signals before the first frame.
    [[nodiscard]] TimelinePoint ready() const { return {ready_.get(), 1}; }

 private:
    struct BatchPlace {
        QueueIndex queue = 0;
        uint64_t rank = 0;  // position among the batches of its queue
        std::vector<QueueWait> waits;
    };
    std::vector<SemaphoreHandle> semaphores_;  // index: queue
    std::vector<BatchPlace> batches_;
    std::vector<uint64_t> counts_;  // index: queue; number of batches
    SemaphoreHandle ready_;
};

}  // namespace weft::vk
