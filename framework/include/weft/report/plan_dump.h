// Purpose: prints plans for people and programs. The same plan always gives the same bytes. Shapes:
//   text: the passes in execution order with their queue, every wait and barrier with its reason, then memory
//   (sum, peak, the resources alive at the peak, heaps, gap between peak and heaps) and culled passes
//   JSON: every field of the plan; ids are indices into graph.passes and graph.resources, null means none
//   DOT: a drawing of passes and resources, with culled ones in grey
//   HTML: a self-contained page with the graph, every queue's timeline, lifetimes, memory, culled passes, and
//   all explanations of `weft explain`
#pragma once

#include <string>

#include "weft/device_profile.h"
#include "weft/plan.h"

namespace weft {

// Prints the plan as text. With a profile, the text names the memory type of each heap.
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
