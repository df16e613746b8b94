// Purpose: a box that floats above the ground, and the outline of its shadow, for tests of shadow maps.
#pragma once

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

#include "weft/scene/scene.h"

namespace weft::test {

// A box of 1 m × 0.8 m × 0.7 m that floats above the ground.
inline const glm::vec3 kBoxLeast{-0.5f, 0.6f, -0.35f}, kBoxMost{0.5f, 1.4f, 0.35f};

inline scene::Mesh box_mesh(const glm::vec3& least, const glm::vec3& most) {
    scene::Mesh mesh;
    for (int axis = 0; axis < 3; ++axis) {
        for (const bool far : {false, true}) {
            const auto first = static_cast<uint32_t>(mesh.positions.size());
            glm::vec3 normal(0);
            normal[axis] = far ? 1.0f : -1.0f;
            for (uint32_t k = 0; k < 4; ++k) {
                glm::vec3 corner;
                corner[axis] = far ? most[axis] : least[axis];
                const int u = (axis + 1) % 3, v = (axis + 2) % 3;
                corner[u] = k == 1 || k == 2 ? most[u] : least[u];
                corner[v] = k >= 2 ? most[v] : least[v];
                mesh.positions.push_back(corner);
                mesh.normals.push_back(normal);
                mesh.tangents.emplace_back(normal.y, normal.z, normal.x, 1);
                mesh.uvs.emplace_back(0, 0);
            }
            const std::array<uint32_t, 6> faces =
                far ? std::array<uint32_t, 6>{0, 1, 2, 0, 2, 3} : std::array<uint32_t, 6>{0, 2, 1, 0, 3, 2};
            for (const uint32_t i : faces) mesh.indices.push_back(first + i);
        }
    }
    mesh.bounds.min = least;
    mesh.bounds.max = most;
    return mesh;
}

// The outline of the box as seen from the sun, in the plane perpendicular to the light, counter-clockwise.
class Outline {
 public:
    explicit Outline(const glm::dvec3& to_sun)
        : right_(glm::normalize(glm::cross(glm::dvec3(0, 1, 0), to_sun))), up_(glm::cross(to_sun, right_)) {
        std::vector<glm::dvec2> corners;
        for (int i = 0; i < 8; ++i)
            corners.push_back(
                place({(i & 1) != 0 ? kBoxMost.x : kBoxLeast.x, (i & 2) != 0 ? kBoxMost.y : kBoxLeast.y,
                       (i & 4) != 0 ? kBoxMost.z : kBoxLeast.z}));
        // The line from corner a to corner b belongs to the outline if all other corners are on its left.
        for (const glm::dvec2& a : corners) {
            for (const glm::dvec2& b : corners) {
                const glm::dvec2 way = b - a;
                if (glm::length(way) < 1e-9) continue;
                const glm::dvec2 left = glm::normalize(glm::dvec2(-way.y, way.x));
                const bool outside = std::ranges::any_of(
                    corners, [&](const glm::dvec2& c) { return glm::dot(c - a, left) < -1e-9; });
                if (!outside) sides_.push_back({a, left});
            }
        }
    }
    // Returns the distance of a point from the edge of the shadow, measured perpendicular to the light, in
    // metres. It is positive inside the shadow.
    [[nodiscard]] double depth_m(const glm::dvec3& point) const {
        double least = std::numeric_limits<double>::infinity();
        for (const Side& side : sides_) least = std::min(least, glm::dot(place(point) - side.at, side.left));
        return least;
    }

 private:
    struct Side {
        glm::dvec2 at, left;
    };
    [[nodiscard]] glm::dvec2 place(const glm::dvec3& point) const {
        return {glm::dot(point, right_), glm::dot(point, up_)};
    }
    glm::dvec3 right_, up_;
    std::vector<Side> sides_;
};

}  // namespace weft::test
