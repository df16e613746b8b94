#include "check/batch_clock.h"

#include <algorithm>
#include <string>
#include <utility>

namespace weft::check {

BatchClock::BatchClock(const FramePlan& plan)
    : plan_(plan),
      known_(plan.schedule.queues.size(), Known(plan.schedule.queues.size(), 0)),
      own_(plan.schedule.queues.size(), 0),
      ends_(plan.submissions.batches.size()) {}

void BatchClock::begin_frame() {
    has_previous_ = std::any_of(own_.begin(), own_.end(), [](uint32_t count) { return count > 0; });
    previous_ends_ = std::exchange(ends_, std::vector<Known>(plan_.submissions.batches.size()));
}

void BatchClock::begin_batch(uint32_t batch, FaultList& faults) {
    const Batch& decl = plan_.submissions.batches[batch];
    queue_ = decl.queue;
    ++own_[queue_];
    for (const QueueWait& wait : decl.waits) {
        if (wait.previous_frame && !has_previous_) continue;
        const std::vector<Known>& ends = wait.previous_frame ? previous_ends_ : ends_;
        if (wait.batch >= ends.size() || ends[wait.batch].empty()) {
            faults.add("C305", {},
                       "batch " + std::to_string(batch) + " waits for batch " + std::to_string(wait.batch) +
                           ", which is not submitted earlier",
                       "a batch can only wait for earlier batches, or for batches of the previous frame");
            continue;
        }
        for (size_t q = 0; q < known_[queue_].size(); ++q)
            known_[queue_][q] = std::max(known_[queue_][q], ends[wait.batch][q]);
    }
}

void BatchClock::end_batch(uint32_t batch) {
    ends_[batch] = known_[queue_];
    ends_[batch][queue_] = own_[queue_];
}

bool BatchClock::covers(const Actor& actor) const {
    // `batch_count` is 0 for work before the first frame, such as the prologue. No semaphore orders this work
    // on its own queue; barriers must do so. All other queues wait for this work with a semaphore before
    // their first batch.
    if (actor.batch_count == 0) return actor.queue != queue_;
    return known_[queue_][actor.queue] >= actor.batch_count;
}

}  // namespace weft::check
