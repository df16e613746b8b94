// Purpose: counts the necessary barriers of a plan. A barrier is necessary if the checker finds an error in
// the plan without it.
#pragma once

#include <cstdint>
#include <optional>

#include "weft/plan.h"

namespace weft {

// Returns the number of necessary barriers in a frame. BarrierPlan::emitted is the number of all barriers.
// `plan` must have no errors. The checker runs once per barrier, so the work is passes × barriers. Returns
// nullopt if this work exceeds `most_work`.
[[nodiscard]] std::optional<uint32_t> count_needed_barriers(FramePlan plan, uint64_t most_work = 100'000);

}  // namespace weft
