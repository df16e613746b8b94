// Purpose: what a plan states about one pass or resource, a line each, in names instead of ids, so that two
// plans can be compared.
#pragma once

#include <string>
#include <vector>

#include "weft/plan.h"

namespace weft {

// In a fixed order, without repeats.
[[nodiscard]] std::vector<std::string> summarize_pass(const FramePlan& plan, PassId pass);
[[nodiscard]] std::vector<std::string> summarize_resource(const FramePlan& plan, ResourceId resource);

}  // namespace weft
