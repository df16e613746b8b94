// Purpose: computes vector clocks. The clock of a position tells, for each queue, which work of that queue is
// known to be complete. No other structure describes the order of work across queues.
#pragma once

#include <cstdint>
#include <vector>

#include "weft/plan.h"

namespace weft {

// Index: queue. 1 + the latest position of the queue that is known to be complete; 0 if none is.
using QueueClock = std::vector<uint32_t>;

// Returns the clock of each position within one frame. Entries of `dependencies` from the previous frame are
// ignored.
[[nodiscard]] std::vector<QueueClock> frame_clocks(const std::vector<QueueIndex>& queue, size_t queue_count,
                                                   const std::vector<QueueDependency>& dependencies);

struct Wait {
    uint32_t position = 0;
    QueueDependency dependency;
};

// Returns the smallest set of waits that ensures all dependencies, repeated in every frame. `queue` has one
// entry more than there are positions: the end of the frame, on queue 0.
[[nodiscard]] std::vector<Wait> minimal_waits(const std::vector<QueueIndex>& queue, size_t queue_count,
                                              const std::vector<QueueDependency>& dependencies);

}  // namespace weft
