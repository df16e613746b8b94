// Purpose: finds out which surfaces of a cell the probes at its corners see. A probe that sees none of them
// is of no use to the cell, and a surface that none of the probes sees needs smaller cells.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "scene/probes/triangle_tree.h"

namespace weft::scene {

// Returns places in the box that are at this distance in front of surfaces, spread over the box. Surfaces
// without an inside count on both sides. The order of the triangles does not change the result.
[[nodiscard]] std::vector<glm::vec3> places_before_surfaces(const TriangleTree& tree, const Bounds& box,
                                                            float distance_m);

struct CellView {
    uint8_t useful = 0;           // Bit i: the probe at corner i sees a surface of the cell.
    bool has_dark_place = false;  // Some free place in front of a surface is seen by no probe.
};

struct ViewLimits {
    float close_m = 0.1f;       // Places at this distance from their surface must be seen.
    float far_m = 0.1f;         // A probe is also useful if it sees only places at this distance.
    float clearance_m = 0.05f;  // A place that is nearer than this to a surface is not free.
};

[[nodiscard]] CellView view_of_cell(const TriangleTree& tree, const Bounds& box,
                                    const std::array<std::optional<glm::vec3>, 8>& probes,
                                    const ViewLimits& limits);

}  // namespace weft::scene
