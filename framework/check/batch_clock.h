// Purpose: tracks which batches each queue has waited for, directly or indirectly. A semaphore signal covers
// all earlier work of the queue that signals, and all work for which this queue has waited before (Vulkan 1.3
// specification, "Semaphore Signaling": the first scope includes all commands submitted earlier to the same
// queue). Time is measured in batches: the batches of each queue are counted over all frames, from 1.
#pragma once

#include <vector>

#include "check/faults/fault_list.h"
#include "weft/plan.h"

namespace weft::check {

class BatchClock {
 public:
    explicit BatchClock(const FramePlan& plan);

    void begin_frame();
    // Starts a batch. From now on, the queue of the batch knows that all work for which the batch waits is
    // complete. Errors: C305, a wait for a batch that is not submitted earlier.
    void begin_batch(uint32_t batch, FaultList& faults);
    void end_batch(uint32_t batch);

    // Sets the queue for which covers(), queue() and batch_count() answer. Call this only between batches.
    void look_from(QueueIndex queue) { queue_ = queue; }
    [[nodiscard]] uint32_t batches_begun(QueueIndex queue) const { return own_[queue]; }

    [[nodiscard]] QueueIndex queue() const { return queue_; }
    [[nodiscard]] uint32_t batch_count() const { return own_[queue_]; }
    // Returns true if semaphores alone ensure that all work of `actor` is complete and visible to the current
    // batch.
    [[nodiscard]] bool covers(const Actor& actor) const;

 private:
    // Index: queue q. Value: the number of batches of q that are known to be complete.
    using Known = std::vector<uint32_t>;

    const FramePlan& plan_;
    std::vector<Known> known_;   // Index: waiting queue. The batches that this queue knows to be complete.
    std::vector<uint32_t> own_;  // Index: queue q. Number of batches of q that have begun so far.
    // Index: batch. `ends_` is for this frame, `previous_ends_` for the previous frame. Each element is a
    // list with one number per queue: how many batches of this queue are known to be complete when the batch
    // is complete. The list is empty if the batch has not ended yet.
    std::vector<Known> ends_, previous_ends_;
    bool has_previous_ = false;
    QueueIndex queue_ = kGraphicsQueue;
};

}  // namespace weft::check
