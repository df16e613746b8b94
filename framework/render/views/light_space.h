// Purpose: the plane perpendicular to the light of the sun, in which the places of shadow maps are computed.
// Units: metres.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <limits>

namespace weft::render {

// The directions in which the column number and the row number in a shadow map grow, and the direction to the
// sun.
struct LightAxes {
    glm::dvec3 right, down, to_sun;

    [[nodiscard]] glm::dvec2 place(const glm::dvec3& point) const {
        return {glm::dot(right, point), glm::dot(down, point)};
    }
};

inline LightAxes light_axes(const glm::vec3& to_sun) {
    const glm::dvec3 back = glm::normalize(glm::dvec3(to_sun));
    const glm::dvec3 up = std::abs(back.y) < 0.99 ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, -1);
    const glm::dvec3 right = glm::normalize(glm::cross(up, back));
    return {right, -glm::cross(back, right), back};
}

// A rectangle in the plane. It is empty if min > max.
struct LightRect {
    glm::dvec2 min{std::numeric_limits<double>::max()};
    glm::dvec2 max{std::numeric_limits<double>::lowest()};

    void add(const glm::dvec2& point) {
        min = glm::min(min, point);
        max = glm::max(max, point);
    }
    void add(const LightRect& other) {
        min = glm::min(min, other.min);
        max = glm::max(max, other.max);
    }
    [[nodiscard]] bool empty() const { return min.x > max.x; }
    [[nodiscard]] glm::dvec2 size() const { return empty() ? glm::dvec2(0) : max - min; }
};

}  // namespace weft::render
