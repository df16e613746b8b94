// Purpose: says what of a scene a graph does not show.
#pragma once

#include "weft/plan.h"
#include "weft/result.h"
#include "weft/scene/scene.h"

namespace weft::render {

// S155, once: transparent objects, where the plan draws surfaces but no transparent ones. A plan that draws
// nothing is about something else than the scene. S157: lights that shine, but for which a buffer has no
// room.
[[nodiscard]] Diagnostics report_unsupported(const FramePlan& plan, const scene::Scene& scene);

}  // namespace weft::render
