// Purpose: prints plans for people and programs. The same plan always gives the same bytes. Formats:
//   - Text lists the passes in execution order with their queue, and every wait and barrier with its reason.
//     Then follow memory (sum, peak, the resources alive at the peak, heaps, gap between peak and heaps) and
//     the culled passes.
//   - JSON has every field of the plan except places in source files and ResolvedGraph::frames. Ids are
//     indices into graph.passes and graph.resources; null means kNoId.
//   - DOT draws passes and resources, with culled ones in grey.
//   - HTML is a self-contained page with the graph, every queue's timeline, lifetimes, memory, culled passes,
//     and all explanations of `weft explain`.
#pragma once

#include <string>

#include "weft/device_profile.h"
#include "weft/plan.h"

namespace weft {

// Prints the plan as text. With a profile, the text also names the memory type from which each heap
// (each allocation of the plan) is allocated.
[[nodiscard]] std::string plan_to_text(const FramePlan& plan, const DeviceProfile* profile = nullptr);
[[nodiscard]] std::string plan_to_json(const FramePlan& plan);
[[nodiscard]] std::string plan_to_dot(const FramePlan& plan);

// Texts for the page of plan_to_html() that are not part of the plan. The page omits empty texts.
struct PlanPageInfo {
    std::string file;
    std::string tier;
    std::string profile;
};
[[nodiscard]] std::string plan_to_html(const FramePlan& plan, const PlanPageInfo& info);

}  // namespace weft
