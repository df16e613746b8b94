#include "scene/probes/grid_frame.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <vector>

#include "scene/probes/triangle_tests.h"

namespace weft::scene {
namespace {

// A surface faces an axis if the cosine between its normal and the axis, or its negative, is at least this
// large (2.6°).
constexpr double kLeastFacing = 0.999;
// A surface is a wall if the vertical part of its normal is at most this large.
constexpr double kMostSlope = 0.05;
// Surfaces whose phases differ by at most this many metres count as one.
constexpr double kThickness_m = 0.05;
// Walls whose directions differ by at most this many degrees count as parallel.
constexpr double kParallel_deg = 0.5;
// Smaller angles of the grid count as 0.
constexpr double kLeastYaw_deg = 1e-3;
// The walls of one direction must have this share of the area of all walls.
constexpr double kLeastShare = 1.0 / 3;
// Corners are rounded to multiples of 1 / kPlacesPerMetre metres.
constexpr double kPlacesPerMetre = 4096;
// Places are rounded to the nearest one; up to 0.53, the lower one counts as the nearest. So rounding does
// not decide where the middle of a scene is exactly between two places.
constexpr double kUpperPlace = 0.47;

using Triangles = std::span<const SolidTriangle>;

// A value on a circle, such as an angle or a phase, and the area that has it.
struct Measured {
    double value = 0;
    double area_m2 = 0;
    auto operator<=>(const Measured&) const = default;
};

// The lowest and the highest coordinate of all corners along an axis.
struct Extent {
    double low_m = 0, high_m = 0;
};

double modulo(double value, double period) {
    return value - period * std::floor(value / period);
}

double area_of(const SolidTriangle& triangle) {
    const glm::dvec3 first(triangle.corners[0]);
    return 0.5 * glm::length(glm::cross(glm::dvec3(triangle.corners[1]) - first,
                                        glm::dvec3(triangle.corners[2]) - first));
}

// Returns the value between 0 and `period` around which the largest area lies, within `width`, and this area.
// The value is a median, so that few surfaces with slightly other values do not change it.
Measured most_common(std::vector<Measured> all, double period, double width) {
    std::ranges::sort(all);
    // The values form a circle, so the list is repeated: element i + n is element i after one more turn.
    const size_t n = all.size();
    const auto value = [&](size_t i) { return all[i % n].value + (i < n ? 0 : period); };
    std::vector<double> sums;  // Sums of the area, from the first element on.
    sums.reserve(2 * n + 1);
    sums.push_back(0);
    for (size_t i = 0; i < 2 * n; ++i) sums.push_back(sums.back() + all[i % n].area_m2);
    double best_m2 = 0;
    size_t best_first = 0;
    for (size_t first = 0, end = 0; first < n; ++first) {
        while (end < first + n && value(end) <= value(first) + width) ++end;
        const double area_m2 = sums[end] - sums[first];
        if (area_m2 <= best_m2) continue;
        best_m2 = area_m2;
        best_first = first;
    }
    if (best_m2 <= 0) return {};
    size_t middle = best_first;
    while (sums[middle + 1] - sums[best_first] < best_m2 / 2) ++middle;
    return {modulo(value(middle), period), best_m2};
}

// Walls at right angles have the same angle modulo 90°.
double common_yaw_deg(Triangles triangles) {
    std::vector<Measured> walls;
    walls.reserve(triangles.size());
    double area_m2 = 0;
    for (const SolidTriangle& triangle : triangles) {
        const glm::dvec3 normal = normal_of(triangle);
        if (normal == glm::dvec3(0) || std::abs(normal.y) > kMostSlope) continue;
        walls.push_back({modulo(glm::degrees(std::atan2(normal.x, normal.z)), 90), area_of(triangle)});
        area_m2 += walls.back().area_m2;
    }
    const Measured most = most_common(std::move(walls), 90, kParallel_deg);
    if (most.area_m2 < kLeastShare * area_m2) return 0;
    const double yaw_deg = most.value > 45 ? most.value - 90 : most.value;
    return std::abs(yaw_deg) < kLeastYaw_deg ? 0 : yaw_deg;
}

// Returns the rotation from world space into a frame with this angle.
glm::dmat3 into_frame(double yaw_deg) {
    return glm::dmat3(glm::rotate(glm::dmat4(1), glm::radians(-yaw_deg), glm::dvec3(0, 1, 0)));
}

Extent extent_of(Triangles triangles, const glm::dvec3& axis) {
    if (triangles.empty()) return {};
    const double first_m = glm::dot(axis, glm::dvec3(triangles.front().corners[0]));
    Extent extent{first_m, first_m};
    for (const SolidTriangle& triangle : triangles)
        for (const glm::vec3& corner : triangle.corners) {
            const double at_m = glm::dot(axis, glm::dvec3(corner));
            extent.low_m = std::min(extent.low_m, at_m);
            extent.high_m = std::max(extent.high_m, at_m);
        }
    return extent;
}

// A triangle that faces an axis, or away from it.
struct Face {
    double at_m = 0;
    double area_m2 = 0;
    bool is_front = true;  // True: light from the positive direction of the axis falls on the triangle.
};

// Returns the triangles that face the axis. The outer sides of a building face the edge of the scene; they
// are left out, because few probes are needed there. The area of a lower triangle is a little larger, so that
// of two equal surfaces the lower one decides, such as a floor before its ceiling.
std::vector<Face> faces_along(Triangles triangles, const glm::dvec3& axis, const Extent& extent,
                              double spacing_m) {
    std::vector<Face> found;
    found.reserve(triangles.size());
    for (const SolidTriangle& triangle : triangles) {
        const double cosine = glm::dot(axis, normal_of(triangle));
        if (std::abs(cosine) < kLeastFacing) continue;
        const std::array<glm::vec3, 3>& c = triangle.corners;
        const double at_m = glm::dot(axis, glm::dvec3(c[0]) + glm::dvec3(c[1]) + glm::dvec3(c[2])) / 3;
        const double free_m = cosine > 0 ? extent.high_m - at_m : at_m - extent.low_m;
        if (triangle.has_inside && free_m < spacing_m) continue;
        const double height = (at_m - extent.low_m) / std::max(extent.high_m - extent.low_m, spacing_m);
        found.push_back(
            {at_m, area_of(triangle) * (1.01 - 0.01 * height), cosine > 0 || !triangle.has_inside});
    }
    return found;
}

double common_phase_m(const std::vector<Face>& faces, double spacing_m) {
    std::vector<Measured> phases;
    phases.reserve(faces.size());
    for (const Face& face : faces) phases.push_back({modulo(face.at_m, spacing_m), face.area_m2});
    return most_common(std::move(phases), spacing_m, kThickness_m).value;
}

// Returns the place of the largest front among the faces of this phase; without a front, of the largest back.
double largest_face_m(const std::vector<Face>& faces, double phase_m, const Extent& extent,
                      double spacing_m) {
    std::vector<Measured> fronts, backs;
    for (const Face& face : faces) {
        const double apart_m = modulo(face.at_m - phase_m, spacing_m);
        if (std::min(apart_m, spacing_m - apart_m) > kThickness_m) continue;
        (face.is_front ? fronts : backs).push_back({face.at_m - extent.low_m, face.area_m2});
    }
    // The places are no circle, so the period is longer than all of them.
    const double period_m = 2 * (extent.high_m - extent.low_m) + 1;
    return extent.low_m +
           most_common(std::move(fronts.empty() ? backs : fronts), period_m, kThickness_m).value;
}

// Returns the coordinate of the origin along an axis of the frame: 0 = x, 1 = y, 2 = z.
double origin_along(Triangles triangles, int axis, const glm::dvec3& direction, double spacing_m) {
    const Extent extent = extent_of(triangles, direction);
    const std::vector<Face> faces = faces_along(triangles, direction, extent, spacing_m);
    if (axis == 1 && faces.empty()) return extent.low_m;
    const double phase_m = faces.empty() ? extent.low_m : common_phase_m(faces, spacing_m);
    if (axis == 1) return largest_face_m(faces, phase_m, extent, spacing_m);
    const double middle_m = (extent.low_m + extent.high_m) / 2;
    return phase_m + spacing_m * std::floor((middle_m - phase_m) / spacing_m + kUpperPlace);
}

}  // namespace

GridFrame grid_frame_of(Triangles triangles, double spacing_m) {
    const double yaw_deg = common_yaw_deg(triangles);
    const glm::dmat3 from_frame = glm::transpose(into_frame(yaw_deg));
    glm::dvec3 origin(0);
    for (int axis = 0; axis < 3; ++axis)
        origin[axis] = origin_along(triangles, axis, from_frame[axis], spacing_m);
    return {static_cast<float>(yaw_deg), glm::vec3(from_frame * origin)};
}

void move_to_grid_frame(std::span<SolidTriangle> triangles, const GridFrame& frame) {
    const glm::dmat3 turn = into_frame(double{frame.yaw_deg});
    for (SolidTriangle& triangle : triangles) {
        for (glm::vec3& corner : triangle.corners) {
            const glm::dvec3 place = turn * (glm::dvec3(corner) - glm::dvec3(frame.origin));
            corner = glm::vec3(glm::round(place * kPlacesPerMetre) / kPlacesPerMetre) + glm::vec3(0);
        }
        put_smallest_corner_first(triangle);
    }
}

glm::vec3 to_grid_frame(const GridFrame& frame, const glm::vec3& world) {
    return glm::vec3(into_frame(double{frame.yaw_deg}) * glm::dvec3(world - frame.origin));
}

glm::vec3 to_world(const GridFrame& frame, const glm::vec3& in_frame) {
    return frame.origin + glm::vec3(glm::transpose(into_frame(double{frame.yaw_deg})) * glm::dvec3(in_frame));
}

}  // namespace weft::scene
