// Purpose: warns about parts of a scene that a graph does not draw.
#pragma once

#include "weft/plan.h"
#include "weft/result.h"
#include "weft/scene/scene.h"

namespace weft::render {

// S155, once: the scene has transparent objects and the plan draws surfaces, but no transparent ones. S157: a
// buffer is too small for all lights with an intensity.
[[nodiscard]] Diagnostics report_unsupported(const FramePlan& plan, const scene::Scene& scene);

}  // namespace weft::render
