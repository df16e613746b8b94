// Purpose: chooses places for reflection probes among the places of the irradiance probes.
#pragma once

#include <vector>

#include "scene/probes/triangle_tree.h"

namespace weft::scene {

// Chooses the probe that sees most others, then the one that sees most of the rest, and so on, until the next
// one would see few more.
[[nodiscard]] std::vector<ReflectionProbe> place_reflections(const TriangleTree& tree,
                                                             const ProbeVolume& volume, uint32_t threads);

}  // namespace weft::scene
