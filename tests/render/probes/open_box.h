// Purpose: a box without its side z = +5, lit by a sun and by a sky of radiance 1 in all directions. The
// published figures of this box are those of one probe that lights itself, and those of all reflections of
// light (radiosity and path tracing). Units: metres, cd/m², lx.
#pragma once

#include <optional>

#include "tests/render/probes/probe_harmonics.h"

namespace weft::test {

inline const glm::dvec3 kBoxLeast{-5, 0, -5}, kBoxMost{5, 6, 5};
inline const glm::dvec3 kBoxToSun{0, std::numbers::sqrt2 / 2, std::numbers::sqrt2 / 2};
inline constexpr double kBoxSun = 10;
inline const glm::dvec3 kBoxProbe{0, 2, 1};
inline const std::array<glm::dvec3, 5> kBoxNormals{glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0),
                                                   glm::dvec3(0, -1, 0), glm::dvec3(0, 0, 1),
                                                   glm::dvec3(0, 0, -1)};
// Irradiance of these normals at kBoxProbe from nine coefficients, for the albedo 0.5: after 1 to 4 rounds of
// a probe that lights itself, and with all reflections.
inline constexpr std::array<std::array<double, 5>, 4> kBoxSelfLit{
    std::array{1.184, 0.358, 2.844, 2.479, 0.501}, std::array{1.753, 1.464, 3.066, 2.774, 1.324},
    std::array{2.049, 1.587, 3.565, 2.962, 1.613}, std::array{2.168, 1.780, 3.630, 3.025, 1.734}};
inline constexpr std::array<double, 5> kBoxAllReflections{1.939, 1.215, 3.501, 2.999, 1.111};

// Returns the radiance that kBoxProbe sees. `before`: the light of the round before; nullopt: none.
inline double box_radiance(const glm::dvec3& direction, double albedo,
                           const std::optional<Harmonics>& before) {
    double nearest_m = 1e30;
    glm::dvec3 normal{0};
    for (int axis = 0; axis < 3; ++axis) {
        if (direction[axis] == 0) continue;
        const double side = direction[axis] > 0 ? kBoxMost[axis] : kBoxLeast[axis];
        const double distance_m = (side - kBoxProbe[axis]) / direction[axis];
        if (distance_m >= nearest_m) continue;
        nearest_m = distance_m;
        normal = glm::dvec3(0);
        normal[axis] = direction[axis] > 0 ? -1 : 1;
    }
    if (normal.z < 0) return 1;  // The sky, through the open side.
    const glm::dvec3 at = kBoxProbe + direction * nearest_m;
    // The edge of the roof at z = 5 throws its shadow to z = -1. The roof shades the other walls.
    const double sun = normal.y > 0 && at.z > -1 ? kBoxSun * kBoxToSun.y : 0;
    return albedo / std::numbers::pi * (sun + (before ? irradiance_of(*before, normal) : 0));
}

// Returns what a probe with size² texels per face sees after some rounds in which it lights itself.
inline Harmonics self_lit_box(uint32_t size, double albedo, int rounds) {
    std::optional<Harmonics> light;
    for (int i = 0; i < rounds; ++i)
        light = project(size, [&](const glm::dvec3& d) { return box_radiance(d, albedo, light); });
    return *light;
}

}  // namespace weft::test
