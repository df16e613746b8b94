// Purpose: vector clocks: for each position, per queue, how far that queue is known to have come. The only
// structure that says what happens before what across queues.
#pragma once

#include <cstdint>
#include <vector>

#include "weft/plan.h"

namespace weft {

using QueueClock = std::vector<uint32_t>;  // by queue: 1 + the latest known point, 0: none

// By position, within one frame. `dependencies` of the previous frame are ignored.
[[nodiscard]] std::vector<QueueClock> frame_clocks(const std::vector<QueueIndex>& queue, size_t queue_count,
                                                   const std::vector<QueueDependency>& dependencies);

struct Wait {
    uint32_t position = 0;
    QueueDependency dependency;
};

// The fewest waits that imply all dependencies, frame after frame. `queue` has one entry more than there are
// positions: the end of the frame on queue 0.
[[nodiscard]] std::vector<Wait> minimal_waits(const std::vector<QueueIndex>& queue, size_t queue_count,
                                              const std::vector<QueueDependency>& dependencies);

}  // namespace weft
