// Purpose: tracks which batches each queue has waited for, directly or indirectly. A semaphore signal covers
// all earlier work of its queue, and all work that this queue had waited for (Vulkan 1.3 specification,
// "Semaphore Signaling": the first scope includes all commands submitted earlier to the same queue). Units:
// batches of one queue, counted over all frames from 1.
#pragma once

#include <vector>

#include "check/faults/fault_list.h"
#include "weft/plan.h"

namespace weft::check {

class BatchClock {
 public:
    explicit BatchClock(const FramePlan& plan);

    void begin_frame();
    // Starts a batch. From now on, its queue knows that all work for which the batch waits is complete.
    // Errors: C305, a wait for a batch that is not submitted earlier.
    void begin_batch(uint32_t batch, FaultList& faults);
    void end_batch(uint32_t batch);

    // Sets the queue to which later queries refer. Call this only between batches.
    void look_from(QueueIndex queue) { queue_ = queue; }
    [[nodiscard]] uint32_t batches_begun(QueueIndex queue) const { return own_[queue]; }

    [[nodiscard]] QueueIndex queue() const { return queue_; }
    [[nodiscard]] uint32_t batch_count() const { return own_[queue_]; }
    // Returns true if semaphores alone ensure that all work of `actor` is complete and visible to the current
    // batch.
    [[nodiscard]] bool covers(const Actor& actor) const;

 private:
    // Index: queue. Number of its batches that are known to be complete.
    using Known = std::vector<uint32_t>;

    const FramePlan& plan_;
    std::vector<Known> known_;   // Index: waiting queue. The batches that this queue knows to be complete.
    std::vector<uint32_t> own_;  // Index: queue. Number of its batches that have begun so far.
    // Index: batch; `ends_` is for this frame, `previous_ends_` for the previous frame. For each queue: the
    // number of its batches that are known to be complete when this batch is complete. Empty if this batch
    // has not ended yet.
    std::vector<Known> ends_, previous_ends_;
    bool has_previous_ = false;
    QueueIndex queue_ = kGraphicsQueue;
};

}  // namespace weft::check
