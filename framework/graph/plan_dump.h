// Purpose: plans as people and programs read them. Deterministic: the same plan gives the same bytes.
// Shapes: text lists what runs in order, with every barrier and its reason, then memory and what was culled;
// JSON holds every field of the plan (ids are indices into graph.passes and graph.resources, null means
// none); DOT draws passes and resources with what was culled in grey.
#pragma once

#include <string>

#include "weft/plan.h"

namespace weft {

[[nodiscard]] std::string plan_to_text(const FramePlan& plan);
[[nodiscard]] std::string plan_to_json(const FramePlan& plan);
[[nodiscard]] std::string plan_to_dot(const FramePlan& plan);

}  // namespace weft
