// Purpose: says what of a scene a graph does not show.
#pragma once

#include "scene/scene.h"
#include "weft/plan.h"
#include "weft/result.h"

namespace weft::render {

// At most one warning, S155: transparent objects, where the plan draws surfaces but no transparent ones. A
// plan that draws nothing is about something else than the scene.
[[nodiscard]] Diagnostics left_out_by(const FramePlan& plan, const scene::Scene& scene);

}  // namespace weft::render
