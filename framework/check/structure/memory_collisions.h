// Purpose: finds the pairs of resources that use the same bytes of a heap while both are alive.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "weft/plan.h"

namespace weft::check {

[[nodiscard]] bool outlives_the_frame(const FramePlan& plan, ResourceId resource);

// Returns the pairs of placements that share bytes while both resources are alive, sorted. The numbers are
// indices into MemoryPlan::placements; the first of a pair is the smaller one.
[[nodiscard]] std::vector<std::pair<uint32_t, uint32_t>> memory_collisions(const FramePlan& plan);

}  // namespace weft::check
