// Purpose: the light probes of a scene as data for shaders, and the views of the faces of the probes. The
// irradiance probes have numbers from 0, in the order of ProbeVolume::probes without those that were dropped.
// Pure functions; no Vulkan. Units: metres.
#pragma once

#include <vector>

#include "shared/frame.glsl"
#include "shared/probe_grid.glsl"
#include "shared/reflection_box.glsl"
#include "weft/scene/probes.h"

namespace weft::render {

// The contents of the imports "probePoints", "probeCells" and "probeGrid".
struct ProbeTables {
    std::vector<shared::ProbePoint> points;
    // A hash table with open addressing; see shared::ProbeCell. It has at least one slot.
    std::vector<shared::ProbeCell> cells;
    shared::ProbeGrid grid{};
};
[[nodiscard]] ProbeTables probe_tables(const scene::ProbeVolume& volume);

// The contents of the imports "reflectionPoints" and "reflectionBoxes".
struct ReflectionTables {
    std::vector<shared::ProbePoint> points;
    std::vector<shared::ReflectionBox> boxes;  // Boxes of 0 for probes without a box.
};
[[nodiscard]] ReflectionTables reflection_tables(const std::vector<scene::ReflectionProbe>& probes);

// Returns the number of probes, without those that were dropped.
[[nodiscard]] uint32_t count_probes(const scene::ProbeVolume& volume);
// Returns the number of slots that a hash table with `cells` cells has.
[[nodiscard]] uint32_t slots_for(size_t cells);
// Returns the views of all probes: view 6 p + f is the face f of probe p; see cube_face(). The previous view
// is the same view, and viewport_px is 1 x 1.
[[nodiscard]] std::vector<shared::ViewConstants> probe_face_views(
    const std::vector<shared::ProbePoint>& points);

}  // namespace weft::render
