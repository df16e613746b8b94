// Purpose: where the shadow maps of the sun lie, the first directional light of a scene: a few nested parts
// of what the camera sees, each seen from the sun in parallel. Pure functions, in double precision. A part is
// what lies between two distances from the eye, bounded by a sphere: its size stays the same however the
// camera turns, and its map moves by whole texels only, so that standing shadows stand still. All maps see
// all of the scene that lies towards the sun: casters are never lost. Units: metres, texels. Source: Zhang et
// al. 2006, "Parallel-Split Shadow Maps for Large-Scale Virtual Environments" (the splits); Valient 2007,
// "Stable Rendering of Cascaded Shadow Maps", ShaderX6 (spheres, whole texels).
#pragma once

#include <array>
#include <string>

#include "shared/frame.glsl"
#include "shared/sun.glsl"
#include "weft/plan.h"
#include "weft/scene/scene.h"

namespace weft::render {

// Which of the sun's views a graph looks through, and how many texels a side what it draws there has.
struct SunMaps {
    uint32_t count = 0;
    std::array<uint32_t, shared::kMostSunCascades> size_px{};
};
// "sun(2)"
[[nodiscard]] std::string sun_view_name(uint32_t cascade);
// Of a view that several passes draw into maps of different sizes the largest counts.
[[nodiscard]] SunMaps sun_maps_of(const FramePlan& plan);

struct SunScene {
    glm::vec3 to_sun{0, 1, 0};  // unit length
    scene::Bounds bounds;       // of all that casts and receives
};

// A map: a square of `size_px` texels that sees along the light, and the sphere that it is there for.
struct SunCascade {
    glm::dvec3 center{0};
    double radius_m = 0;
    double end_m = 0;  // distance from the eye; the last one's is infinite where it holds the whole scene
    double texel_m = 0;
    glm::dvec2 origin_texels{0};  // the map's upper left corner in the plane across the light: whole numbers
};

// The ends of `count` parts of near to far, of which the last is `far_m`: between equal ratios and equal
// steps.
[[nodiscard]] std::array<double, shared::kMostSunCascades> split_distances(double near_m, double far_m,
                                                                           uint32_t count);

struct SunCascades {
    uint32_t count = 0;
    std::array<SunCascade, shared::kMostSunCascades> cascades;
    shared::SunConstants constants{};
    // What a pass that looks through "sun(i)" gets.
    std::array<shared::ViewConstants, shared::kMostSunCascades> views{};
};
// `aspect` is the picture's width / height.
[[nodiscard]] SunCascades sun_cascades(const scene::Camera& camera, float aspect, const SunScene& scene,
                                       const SunMaps& maps);

}  // namespace weft::render
