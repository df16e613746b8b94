// Purpose: prints plans for people and programs. Deterministic: the same plan gives the same bytes. Shapes:
// text lists the passes in execution order with their queue, and every wait and barrier with its reason, then
// memory (sum, peak and the resources alive there, heaps, gap) and culled passes; JSON has every field of the
// plan (ids are indices into graph.passes and graph.resources, null means none); DOT draws passes and
// resources, with culled ones in grey; HTML is a self-contained page with the graph, every queue's timeline,
// lifetimes, memory, culled passes, and all explanations of `weft explain`.
#pragma once

#include <string>

#include "weft/device_profile.h"
#include "weft/plan.h"

namespace weft {

// With a profile, memory is listed with its type.
[[nodiscard]] std::string plan_to_text(const FramePlan& plan, const DeviceProfile* profile = nullptr);
[[nodiscard]] std::string plan_to_json(const FramePlan& plan);
[[nodiscard]] std::string plan_to_dot(const FramePlan& plan);

// Information for the page that is not part of the plan. Empty members are omitted.
struct PlanPageInfo {
    std::string file;
    std::string tier;
    std::string profile;
};
[[nodiscard]] std::string plan_to_html(const FramePlan& plan, const PlanPageInfo& info);

}  // namespace weft
