// Purpose: plans as people and programs read them. Deterministic: the same plan gives the same bytes.
// Shapes: text lists what runs in order, on which queue, with every wait and barrier and its reason, then
// memory (sum, peak and who is alive there, heaps, gap) and what was culled; JSON holds every field of the
// plan (ids are indices into graph.passes and graph.resources, null means none); DOT draws passes and
// resources with what was culled in grey; HTML is one page that needs nothing else: the graph, every queue's
// timeline, lifetimes, memory, what was culled, and every explanation of `weft explain` where it belongs.
#pragma once

#include <string>

#include "weft/device_profile.h"
#include "weft/plan.h"

namespace weft {

// With a profile, memory says of which type it is.
[[nodiscard]] std::string plan_to_text(const FramePlan& plan, const DeviceProfile* profile = nullptr);
[[nodiscard]] std::string plan_to_json(const FramePlan& plan);
[[nodiscard]] std::string plan_to_dot(const FramePlan& plan);

// What a page says about a plan that the plan doesn't know. Empty: not mentioned.
struct PlanPageInfo {
    std::string file;
    std::string tier;
    std::string profile;
};
[[nodiscard]] std::string plan_to_html(const FramePlan& plan, const PlanPageInfo& info);

}  // namespace weft
