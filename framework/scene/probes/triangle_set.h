// Purpose: the triangles of a scene in world space, for questions about visibility.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "weft/scene/load_progress.h"
#include "weft/scene/scene.h"

namespace weft::scene {

// A triangle whose front is counter-clockwise. The first corner is the smallest in the order of (x, y, z), so
// that the corners of two equal triangles are equal bit for bit.
struct SolidTriangle {
    std::array<glm::vec3, 3> corners;
    bool blocks = true;  // False for surfaces that let light through: transparent ones and masks with holes.
    bool has_inside = true;  // False for surfaces whose back does not mean the inside of an object.
};

// Turns the order of the corners, so that the smallest is the first.
void put_smallest_corner_first(SolidTriangle& triangle);

// Farther than this from the origin, in metres, geometry does not count.
inline constexpr float kFarthest_m = 1e5f;

// Returns the number of triangles of all instances that do not move.
[[nodiscard]] uint64_t count_triangles(const Scene& scene);
[[nodiscard]] std::vector<SolidTriangle> collect_triangles(const Scene& scene, const LoadOptions& options);

}  // namespace weft::scene
