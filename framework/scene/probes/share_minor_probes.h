// Purpose: saves probes where the light varies slowly. Outside of buildings and above grounds, probes see
// much of the sky. There, one probe gives the light of several grid points.
#pragma once

#include "scene/probes/triangle_tree.h"
#include "weft/scene/probes.h"

namespace weft::scene {

// Drops minor probes that have a substitute: another minor probe near them that sees nearly the same places.
// Tries larger and larger distances of the substitutes, until at most `most` probes are left or the largest
// distance was tried. Returns the number of probes that are left.
uint32_t share_minor_probes(const TriangleTree& tree, ProbeVolume& volume, uint32_t most, uint32_t threads);

}  // namespace weft::scene
