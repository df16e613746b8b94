// Purpose: describes one pass, resource or group of a plan in lines of text. The lines contain names instead
// of ids, so that the lines of two plans can be compared.
#pragma once

#include <string>
#include <vector>

#include "weft/plan.h"

namespace weft {

// Returns the lines in a fixed order. No line occurs twice.
[[nodiscard]] std::vector<std::string> summarize_pass(const FramePlan& plan, PassId pass);
[[nodiscard]] std::vector<std::string> summarize_resource(const FramePlan& plan, ResourceId resource);
// `group` is an index into ResolvedGraph::groups.
[[nodiscard]] std::vector<std::string> summarize_group(const FramePlan& plan, uint32_t group);

}  // namespace weft
