// Purpose: computes the light that a uniformly emitting capsule or rectangle sends to a point, by sampling
// its surface in double precision. It uses no closed form, so it is independent of the shaders.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

#include "shared/light.glsl"

namespace weft::test {

inline double window_of(double distance_m, double range_m) {
    return range_m > 0 ? std::clamp(1 - std::pow(distance_m / range_m, 4), 0.0, 1.0) : 1;
}

// Calls visit(direction, solid angle) for one patch of a light's surface, if the patch faces the point `at`.
// The direction leads from `at` to the patch. `from` is the centre of the patch, and `facing` is its normal.
template <class Visit>
void visit_patch(const glm::dvec3& from, const glm::dvec3& facing, double area, const glm::dvec3& at,
                 const Visit& visit) {
    const glm::dvec3 way = from - at;
    const double distance2 = glm::dot(way, way), sent = -glm::dot(facing, way);
    if (sent > 0) visit(way / std::sqrt(distance2), area * sent / (distance2 * std::sqrt(distance2)));
}

template <class Visit>
void visit_rectangle(const shared::Light& light, const glm::dvec3& at, const Visit& visit, int columns = 250,
                     int rows = 250) {
    const glm::dvec3 middle(light.position), side(light.side), facing(light.direction);
    const glm::dvec3 up = glm::cross(side, facing);
    const double a = light.half_size_m.x, b = light.half_size_m.y;
    for (int i = 0; i < columns; ++i) {
        const glm::dvec3 column = middle + side * (a * ((2 * i + 1.0) / columns - 1));
        for (int j = 0; j < rows; ++j)
            visit_patch(column + up * (b * ((2 * j + 1.0) / rows - 1)), facing, 4 * a * b / columns / rows,
                        at, visit);
    }
}

// Visits patches of a capsule's surface. The cylinder is divided into equal steps around the axis and along
// it. The half spheres are divided into slices of equal height, because such slices have equal areas.
template <class Visit>
void visit_capsule(const shared::Light& light, const glm::dvec3& at, const Visit& visit, int turns = 360,
                   int steps = 150) {
    constexpr double kTurn = 6.283185307179586;
    const glm::dvec3 middle(light.position), axis = glm::normalize(glm::dvec3(light.direction));
    const glm::dvec3 steep = std::abs(axis.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
    const glm::dvec3 x = glm::normalize(glm::cross(axis, steep)), y = glm::cross(axis, x);
    const double half = light.half_size_m.x, radius = light.half_size_m.y;
    const double strip = radius * kTurn / turns / steps;
    for (int i = 0; i < turns; ++i) {
        const double turn = kTurn * (i + 0.5) / turns;
        const glm::dvec3 out = x * std::cos(turn) + y * std::sin(turn);
        for (int j = 0; j < steps; ++j) {
            const double share = (j + 0.5) / steps, across = std::sqrt(1 - share * share);
            visit_patch(middle + axis * (half * (2 * share - 1)) + out * radius, out, strip * 2 * half, at,
                        visit);
            for (const double end : {-1.0, 1.0}) {
                const glm::dvec3 facing = out * across + axis * (end * share);
                visit_patch(middle + axis * (end * half) + facing * radius, facing, strip * radius, at,
                            visit);
            }
        }
    }
}

template <class Visit>
void visit_light(const shared::Light& light, const glm::dvec3& at, const Visit& visit) {
    if (light.type == shared::kLightRectangle) return visit_rectangle(light, at, visit);
    visit_capsule(light, at, visit);
}

// Like the overload above, but the caller chooses the size of the patches: each is about `patch_m` metres
// long, or shorter if a direction of the surface would otherwise have fewer than 16 patches.
template <class Visit>
void visit_light(const shared::Light& light, const glm::dvec3& at, const Visit& visit, double patch_m) {
    const auto patches = [&](double length_m) {
        return static_cast<int>(std::ceil(std::max(length_m / patch_m, 16.0)));
    };
    const double a = 2.0 * light.half_size_m.x, b = 2.0 * light.half_size_m.y;
    if (light.type == shared::kLightRectangle)
        return visit_rectangle(light, at, visit, patches(a), patches(b));
    visit_capsule(light, at, visit, 2 * patches(1.6 * b), patches(a));
}

// Returns the distance from `at` to the nearest point of a rectangle light, or of the axis of a capsule
// light, in metres.
inline double distance_to_light(const shared::Light& light, const glm::dvec3& at) {
    const glm::dvec3 way = at - glm::dvec3(light.position), direction(light.direction), side(light.side);
    const double a = light.half_size_m.x, b = light.half_size_m.y;
    if (light.type == shared::kLightCapsule)
        return glm::length(way - direction * std::clamp(glm::dot(way, direction), -a, a));
    const glm::dvec3 up = glm::cross(side, direction);
    return glm::length(glm::dvec3(std::max(std::abs(glm::dot(way, side)) - a, 0.0),
                                  std::max(std::abs(glm::dot(way, up)) - b, 0.0), glm::dot(way, direction)));
}

inline double area_irradiance(const shared::Light& light, const glm::dvec3& at, const glm::dvec3& normal) {
    double sum = 0;
    visit_light(light, at, [&](const glm::dvec3& direction, double solid_angle) {
        sum += std::max(0.0, glm::dot(direction, normal)) * solid_angle;
    });
    return sum * window_of(distance_to_light(light, at), light.range_m);
}

}  // namespace weft::test
