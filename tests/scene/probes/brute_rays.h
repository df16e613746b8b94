// Purpose: answers questions about visibility by asking every triangle, with code of its own, to check the
// code that places probes.
#pragma once

#include <vector>

#include "weft/scene/scene.h"

namespace weft::scene::test {

class BruteRays {
 public:
    explicit BruteRays(const Scene& scene);

    // Returns the share of random directions in which the nearest surface shows its back.
    [[nodiscard]] double back_share(const glm::vec3& point) const;
    [[nodiscard]] bool sees(const glm::vec3& from, const glm::vec3& to) const;
    // Returns points in front of the surfaces, at this distance.
    [[nodiscard]] std::vector<glm::vec3> points_before_surfaces(float distance_m,
                                                                uint32_t per_triangle) const;
    // Returns random points in front of the surfaces, at this distance. Each part of an area is equally
    // likely.
    [[nodiscard]] std::vector<glm::vec3> random_points(uint32_t count, float distance_m, uint32_t seed) const;

 private:
    struct Triangle {
        glm::vec3 a, b, c, normal;
    };
    // Returns the distance of the triangle in the direction, or a negative number.
    [[nodiscard]] static float distance(const Triangle& triangle, const glm::vec3& from,
                                        const glm::vec3& direction);

    std::vector<Triangle> triangles_;
};

}  // namespace weft::scene::test
