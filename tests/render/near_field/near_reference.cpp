#include "tests/render/near_field/near_reference.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <limits>

namespace weft::test {
namespace {

// Returns true if a ray from a point outside of the box hits the box.
bool hits(const glm::dvec3& from, const glm::dvec3& way, const Box& box) {
    double enter = 0, leave = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
        const double inverse = 1 / (way[axis] == 0 ? 1e-30 : way[axis]);
        const double a = (box.least[axis] - from[axis]) * inverse,
                     b = (box.most[axis] - from[axis]) * inverse;
        enter = std::max(enter, std::min(a, b));
        leave = std::min(leave, std::max(a, b));
    }
    return enter < leave;
}

}  // namespace

Openness openness_of(const glm::dvec3& point, const std::vector<Box>& boxes) {
    constexpr int kSide = 128;
    Openness open;
    for (int i = 0; i < kSide * kSide; ++i) {
        const double square = (i / kSide + 0.5) / kSide;
        const double turn = 2 * glm::pi<double>() * (i % kSide + 0.5) / kSide;
        const glm::dvec3 way(std::sqrt(square) * std::cos(turn), std::sqrt(1 - square),
                             std::sqrt(square) * std::sin(turn));
        const glm::dvec3 from = point + glm::dvec3(0, 1e-6, 0);
        if (std::ranges::any_of(boxes, [&](const Box& box) { return hits(from, way, box); })) continue;
        open.visibility += 1.0 / (kSide * kSide);
        open.direction += way;
    }
    open.direction = glm::normalize(open.direction + glm::dvec3(0, 1e-9, 0));
    return open;
}

}  // namespace weft::test
