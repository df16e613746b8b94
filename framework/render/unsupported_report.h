// Purpose: warns about parts of a scene that a graph does not draw.
#pragma once

#include "weft/plan.h"
#include "weft/result.h"
#include "weft/scene/scene.h"

namespace weft::render {

// Returns warnings about the parts of the scene that the plan does not draw. S155 (at most once): the scene
// has transparent objects; the plan draws other objects, but not the transparent ones. S157: the plan's light
// buffer is too small for all lights with an intensity above 0.
[[nodiscard]] Diagnostics report_unsupported(const FramePlan& plan, const scene::Scene& scene);

}  // namespace weft::render
