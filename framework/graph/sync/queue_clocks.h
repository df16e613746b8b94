// Purpose: computes vector clocks, and from them the necessary semaphore waits between queues. The clock of a
// position tells, for each queue, which work of that queue is known to be complete.
#pragma once

#include <cstdint>
#include <vector>

#include "weft/plan.h"

namespace weft {

// Returns the vector clock of each schedule position. It tells which positions of the same frame surely run
// before this position. Dependencies on the previous frame are ignored.
[[nodiscard]] ClockTable frame_clocks(const std::vector<QueueIndex>& queue, size_t queue_count,
                                      const std::vector<QueueDependency>& dependencies);

struct Wait {
    Position position = 0;
    QueueDependency dependency;
};

// Returns a minimal set of semaphore waits that ensures all dependencies in every frame. `queue` is the queue
// of each position, with one more entry at the end: the end of the frame, on queue 0.
[[nodiscard]] std::vector<Wait> minimal_waits(const std::vector<QueueIndex>& queue, size_t queue_count,
                                              const std::vector<QueueDependency>& dependencies);

}  // namespace weft
