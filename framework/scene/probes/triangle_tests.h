// Purpose: tests of one triangle against a ray, a box and a ball, computed in double precision.
#pragma once

#include <optional>

#include "scene/probes/triangle_tree.h"

namespace weft::scene {

// Both sides of the triangle count. A ray that is nearly parallel to the triangle misses it.
[[nodiscard]] std::optional<RayHit> hit_triangle(const SolidTriangle& triangle, const Ray& ray);
[[nodiscard]] bool touches_box(const SolidTriangle& triangle, const Bounds& box);
[[nodiscard]] double squared_distance(const SolidTriangle& triangle, const glm::dvec3& point);
// Returns the normal of the front, or 0 for a triangle without an area.
[[nodiscard]] glm::dvec3 normal_of(const SolidTriangle& triangle);

}  // namespace weft::scene
