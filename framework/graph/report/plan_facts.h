// Purpose: what a plan states about one pass or resource, a line each, in names instead of ids, so that two
// plans can be compared.
#pragma once

#include <string>
#include <vector>

#include "weft/plan.h"

namespace weft {

// In a fixed order, without repeats.
[[nodiscard]] std::vector<std::string> pass_facts(const FramePlan& plan, PassId pass);
[[nodiscard]] std::vector<std::string> resource_facts(const FramePlan& plan, ResourceId resource);

}  // namespace weft
