// Sources: ray and triangle: Möller and Trumbore 1997, "Fast, Minimum Storage Ray/Triangle Intersection".
// Box and triangle: Akenine-Möller 2001, "Fast 3D Triangle-Box Overlap Testing". Point and triangle: Ericson
// 2005, "Real-Time Collision Detection", section 5.1.5.
#include "scene/probes/triangle_tests.h"

#include <algorithm>
#include <cmath>

namespace weft::scene {
namespace {

// A ray misses a triangle if the sine of the angle between them is smaller than this.
constexpr double kParallel = 1e-6;

// True if the axis separates the triangle `c`, given relative to the centre of the box, from the box.
bool separates(const glm::dvec3& axis, const std::array<glm::dvec3, 3>& c, const glm::dvec3& half) {
    const double a = glm::dot(axis, c[0]), b = glm::dot(axis, c[1]), d = glm::dot(axis, c[2]);
    const double radius = glm::dot(glm::abs(axis), half);
    return std::min({a, b, d}) > radius || std::max({a, b, d}) < -radius;
}

}  // namespace

std::optional<RayHit> hit_triangle(const SolidTriangle& triangle, const Ray& ray) {
    const glm::dvec3 a(triangle.corners[0]);
    const glm::dvec3 ab = glm::dvec3(triangle.corners[1]) - a, ac = glm::dvec3(triangle.corners[2]) - a;
    const glm::dvec3 p = glm::cross(ray.direction, ac);
    const double determinant = glm::dot(ab, p);
    const glm::dvec3 normal = glm::cross(ab, ac);
    if (determinant * determinant <= kParallel * kParallel * glm::dot(normal, normal)) return std::nullopt;
    const double inverse = 1 / determinant;
    const glm::dvec3 s = ray.origin - a;
    const double u = glm::dot(s, p) * inverse;
    if (u < 0 || u > 1) return std::nullopt;
    const glm::dvec3 q = glm::cross(s, ab);
    const double v = glm::dot(ray.direction, q) * inverse;
    if (v < 0 || u + v > 1) return std::nullopt;
    const double distance = glm::dot(ac, q) * inverse;
    if (distance < 0 || distance > ray.reach_m) return std::nullopt;
    return RayHit{distance, determinant < 0 && triangle.has_inside, determinant < 0};
}

bool touches_box(const SolidTriangle& triangle, const Bounds& box) {
    const glm::dvec3 centre = (glm::dvec3(box.min) + glm::dvec3(box.max)) * 0.5;
    const glm::dvec3 half = (glm::dvec3(box.max) - glm::dvec3(box.min)) * 0.5;
    std::array<glm::dvec3, 3> c;
    for (size_t i = 0; i < 3; ++i) c[i] = glm::dvec3(triangle.corners[i]) - centre;
    for (int axis = 0; axis < 3; ++axis) {
        glm::dvec3 unit(0);
        unit[axis] = 1;
        if (separates(unit, c, half)) return false;
        for (size_t edge = 0; edge < 3; ++edge)
            if (separates(glm::cross(unit, c[(edge + 1) % 3] - c[edge]), c, half)) return false;
    }
    return !separates(glm::cross(c[1] - c[0], c[2] - c[0]), c, half);
}

double squared_distance(const SolidTriangle& triangle, const glm::dvec3& point) {
    const glm::dvec3 a(triangle.corners[0]), b(triangle.corners[1]), c(triangle.corners[2]);
    const glm::dvec3 ab = b - a, ac = c - a;
    const auto to_edge = [&](const glm::dvec3& from, const glm::dvec3& edge) {
        const double length = glm::dot(edge, edge);
        const double t = length > 0 ? std::clamp(glm::dot(point - from, edge) / length, 0.0, 1.0) : 0.0;
        const glm::dvec3 gap = point - (from + edge * t);
        return glm::dot(gap, gap);
    };
    const double to_edges = std::min({to_edge(a, ab), to_edge(a, ac), to_edge(b, c - b)});
    const glm::dvec3 normal = glm::cross(ab, ac);
    const double area = glm::dot(normal, normal);
    if (area <= 0) return to_edges;
    const glm::dvec3 s = point - a;
    const double v = glm::dot(glm::cross(ab, s), normal) / area,
                 u = glm::dot(glm::cross(s, ac), normal) / area;
    if (u < 0 || v < 0 || u + v > 1) return to_edges;
    const double height = glm::dot(s, normal);
    return std::min(to_edges, height * height / area);
}

glm::dvec3 normal_of(const SolidTriangle& triangle) {
    const glm::dvec3 a(triangle.corners[0]);
    const glm::dvec3 normal =
        glm::cross(glm::dvec3(triangle.corners[1]) - a, glm::dvec3(triangle.corners[2]) - a);
    const double length = glm::length(normal);
    return length > 0 ? normal / length : glm::dvec3(0);
}

}  // namespace weft::scene
