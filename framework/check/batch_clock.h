// Purpose: what each queue knows of the others while the batches of a plan run: a semaphore tells of
// everything its queue had done, and of everything that queue knew itself (Vulkan 1.3 specification,
// "Semaphore Signaling": the first scope holds all commands submitted earlier to the same queue). Units:
// batches of one queue, counted over all frames from 1.
#pragma once

#include <vector>

#include "check/fault_list.h"
#include "weft/plan.h"

namespace weft::check {

class BatchClock {
 public:
    explicit BatchClock(const FramePlan& plan);

    void begin_frame();
    // Waits for what the batch waits for. Faults: C305, a wait for a batch that is not submitted earlier.
    void begin_batch(uint32_t batch, FaultList& faults);
    void end_batch(uint32_t batch);

    // From here on questions are asked for `queue`, between batches.
    void look_from(QueueIndex queue) { queue_ = queue; }
    [[nodiscard]] uint32_t batches_begun(QueueIndex queue) const { return own_[queue]; }

    [[nodiscard]] QueueIndex queue() const { return queue_; }
    [[nodiscard]] uint32_t batch_count() const { return own_[queue_]; }
    // Whether all that `actor` did is over, and its memory visible, for whatever the present batch does,
    // thanks to semaphores alone.
    [[nodiscard]] bool covers(const Actor& actor) const;

 private:
    using Known = std::vector<uint32_t>;  // by queue: batches known to be over

    const FramePlan& plan_;
    std::vector<Known> known_;                 // by queue
    std::vector<uint32_t> own_;                // by queue: batches begun
    std::vector<Known> ends_, previous_ends_;  // by batch, of this frame and the one before; empty: not yet
    bool has_previous_ = false;
    QueueIndex queue_ = 0;
};

}  // namespace weft::check
