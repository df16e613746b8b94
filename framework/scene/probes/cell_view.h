// Purpose: finds out which surfaces of a cell are visible from the probes at the corners of the cell. A probe
// that sees none of these surfaces is of no use to the cell. If no probe of the cell sees a surface, the
// cells there must be smaller.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "scene/probes/triangle_tree.h"

namespace weft::scene {

// Returns places in the box that are at this distance in front of surfaces, spread over the box. A surface
// without an inside (SolidTriangle::has_inside is false) has places on both sides. The order of the triangles
// does not change the result.
[[nodiscard]] std::vector<glm::vec3> places_before_surfaces(const TriangleTree& tree, const Bounds& box,
                                                            float distance_m);

struct CellView {
    uint8_t useful = 0;           // Bit i: the probe at corner i sees a surface of the cell.
    bool has_dark_place = false;  // There is a free place in front of a surface that no probe sees.
};

struct ViewLimits {
    float close_m = 0.1f;       // Distance in front of surfaces of the places that probes must see.
    float far_m = 0.1f;         // A probe that sees only places at this larger distance is useful, too.
    float clearance_m = 0.05f;  // A place that is nearer than this to a surface is not free.
};

[[nodiscard]] CellView view_of_cell(const TriangleTree& tree, const Bounds& box,
                                    const std::array<std::optional<glm::vec3>, 8>& probes,
                                    const ViewLimits& limits);

}  // namespace weft::scene
