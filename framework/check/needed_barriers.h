// Purpose: counts a plan's necessary barriers: a barrier is necessary if the checker finds a fault without
// it.
#pragma once

#include <cstdint>
#include <optional>

#include "weft/plan.h"

namespace weft {

// Counts the barriers of a frame, like BarrierPlan::emitted; removes one at a time. The plan must be free of
// faults. The checker runs once per barrier, so the work is passes × barriers; nullopt if this exceeds
// `most_work`.
[[nodiscard]] std::optional<uint32_t> count_needed_barriers(FramePlan plan, uint64_t most_work = 100'000);

}  // namespace weft
