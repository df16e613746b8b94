// Purpose: small scenes for tests of light probes. Most consist of boxes, so that a test can tell without
// rays whether a point is inside of a wall.
#pragma once

#include <random>
#include <vector>

#include "weft/scene/scene.h"

namespace weft::scene::test {

struct BoxScene {
    Scene scene;
    std::vector<Bounds> boxes;  // The solid boxes.

    BoxScene();
    // Adds a solid box of the opaque, one-sided material 0.
    void add(glm::vec3 low, glm::vec3 high);
    // Adds the six walls of a closed room, which has the given inner bounds.
    void add_room(glm::vec3 low, glm::vec3 high, float wall_m);
    [[nodiscard]] bool is_inside(const glm::vec3& point) const;
    // The same for boxes that are larger on all sides by `margin_m`.
    [[nodiscard]] bool is_near(const glm::vec3& point, float margin_m) const;
};

[[nodiscard]] BoxScene open_court();
[[nodiscard]] BoxScene corridor();
[[nodiscard]] BoxScene object_in_the_open();
[[nodiscard]] BoxScene two_floors();
[[nodiscard]] BoxScene room_in_a_room();
[[nodiscard]] BoxScene house_on_wide_ground();
// 5 × 2 × 5 closed rooms of 2.6 m. Room (i, j, k) has its middle at 1.3 m + 2.9 m × (i, j, k).
[[nodiscard]] BoxScene apartments();
// Random walls, slabs and blocks around the origin.
[[nodiscard]] BoxScene random_boxes(uint32_t seed);

// A height field of 1 km with the given number of cells along each side.
[[nodiscard]] Scene terrain(uint32_t cells);
[[nodiscard]] float terrain_height(float x, float z);

// Returns the same scene with its meshes, instances and triangles in another order, and with other first
// corners of the triangles.
[[nodiscard]] Scene shuffled(const Scene& scene, uint32_t seed);

}  // namespace weft::scene::test
