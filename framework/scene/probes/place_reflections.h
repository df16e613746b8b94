// Purpose: chooses places for reflection probes among the places of the irradiance probes.
#pragma once

#include <vector>

#include "scene/probes/triangle_tree.h"

namespace weft::scene {

// Chooses places of irradiance probes for the reflection probes. First chooses the place that sees most
// irradiance probes. Then chooses the place that sees most of the remaining irradiance probes, and so on.
// Ends when the next place would see only few more.
[[nodiscard]] std::vector<ReflectionProbe> place_reflections(const TriangleTree& tree,
                                                             const ProbeVolume& volume, uint32_t threads);

}  // namespace weft::scene
