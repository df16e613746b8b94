// Purpose: how many of a plan's barriers are needed: without one of them the checker finds a fault.
#pragma once

#include <cstdint>
#include <optional>

#include "weft/plan.h"

namespace weft {

// Of the barriers of a frame, as BarrierPlan::emitted counts them; each is left out by itself. The plan is
// sound. The checker runs once for each barrier, so the work grows with passes × barriers: nothing where that
// product is above `most_work`.
[[nodiscard]] std::optional<uint32_t> count_needed_barriers(FramePlan plan, uint64_t most_work = 100'000);

}  // namespace weft
