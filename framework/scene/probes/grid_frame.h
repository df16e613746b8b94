// Purpose: the frame in which probes are placed. It moves with the scene, and turns with its walls: if all
// objects move together, each probe moves by the same way, and the light stays the same. The walls tell the
// angle only modulo 90°, so the probes turn with the scene by at most 45°.
#pragma once

#include <span>

#include "scene/probes/triangle_set.h"

namespace weft::scene {

struct GridFrame {
    float yaw_deg = 0;    // The angle around +y from the world to the frame, counter-clockwise.
    glm::vec3 origin{0};  // In world space.
};

// Returns the frame for a grid with this smallest spacing. The order of the triangles does not matter.
//
// The angle: the walls of most buildings stand at right angles. The axes x and z of the frame are parallel to
// the walls that have the largest area. If the walls of no direction have a third of the area of all walls,
// the angle is 0.
//
// The origin: the place of a wall, floor or ceiling along an axis, modulo the spacing, is its phase. The
// origin has the phase of most of their area, so that grid points half a spacing beside the origin are half a
// spacing in front of these surfaces. Of all places with this phase, the origin is that near the middle of
// the scene along x and z, so that the grid of a symmetric building is symmetric. Along y, the origin is the
// largest floor.
[[nodiscard]] GridFrame grid_frame_of(std::span<const SolidTriangle> triangles, double spacing_m);

// Moves the triangles from world space into the frame, and rounds their corners to multiples of 1/4096 m. So
// the triangles do not depend on where the scene lies in the world: without rounding, a sum of floats depends
// on it.
void move_to_grid_frame(std::span<SolidTriangle> triangles, const GridFrame& frame);

[[nodiscard]] glm::vec3 to_grid_frame(const GridFrame& frame, const glm::vec3& world);
[[nodiscard]] glm::vec3 to_world(const GridFrame& frame, const glm::vec3& in_frame);

}  // namespace weft::scene
