// Purpose: computes vector clocks. The clock of a position tells, for each queue, which work of that queue is
// known to be complete. No other structure describes the order of work across queues.
#pragma once

#include <cstdint>
#include <vector>

#include "weft/plan.h"

namespace weft {

// Returns the vector clock of each schedule position. It tells which positions of the same frame surely run
// before. Dependencies on the previous frame are ignored.
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
