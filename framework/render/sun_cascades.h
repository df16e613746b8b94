// Purpose: computes the shadow maps of the sun, which is the first directional light of a scene: a few nested
// parts of the camera's view, each seen from the sun in parallel projection. Pure functions in double
// precision. A part lies between two distances from the eye and is bounded by a sphere. Its size does not
// change when the camera rotates, and its map moves by whole texels only, so static shadows do not flicker.
// Every map covers the whole scene in the direction of the sun, so no shadow caster is missed. Units: metres,
// texels. Source: Zhang et al. 2006, "Parallel-Split Shadow Maps for Large-Scale Virtual Environments" (the
// splits); Valient 2007, "Stable Rendering of Cascaded Shadow Maps", ShaderX6 (spheres, whole texels).
#pragma once

#include <array>
#include <string>

#include "shared/frame.glsl"
#include "shared/sun.glsl"
#include "weft/plan.h"
#include "weft/scene/scene.h"

namespace weft::render {

// The sun's views that a graph uses, and the side of their maps in texels.
struct SunMaps {
    uint32_t count = 0;
    std::array<uint32_t, shared::kMostSunCascades> size_px{};
};
// Such as "sun(2)".
[[nodiscard]] std::string sun_view_name(uint32_t cascade);
// If several passes draw a view at different sizes, the largest size is used.
[[nodiscard]] SunMaps sun_maps_of(const FramePlan& plan);

struct SunScene {
    glm::vec3 to_sun{0, 1, 0};  // unit length
    scene::Bounds bounds;       // bounds of all shadow casters and receivers
};

// A shadow map: a square of `size_px` texels, projected along the light, and the sphere that it must cover.
struct SunCascade {
    glm::dvec3 center{0};
    double radius_m = 0;
    double end_m = 0;  // end of its distance range from the eye; infinite for the last map if it covers the
                       // whole scene
    double texel_m = 0;
    glm::dvec2 origin_texels{0};  // the map's upper left corner on the plane perpendicular to the light, in
                                  // whole texels
};

// The ends of `count` parts of the range from near to far; a mean of equal ratios and equal steps. The last
// end is `far_m`.
[[nodiscard]] std::array<double, shared::kMostSunCascades> split_distances(double near_m, double far_m,
                                                                           uint32_t count);

struct SunCascades {
    uint32_t count = 0;
    std::array<SunCascade, shared::kMostSunCascades> cascades;
    shared::SunConstants constants{};
    // view constants for passes with the view "sun(i)"
    std::array<shared::ViewConstants, shared::kMostSunCascades> views{};
};
// `aspect` is width / height of the picture.
[[nodiscard]] SunCascades sun_cascades(const scene::Camera& camera, float aspect, const SunScene& scene,
                                       const SunMaps& maps);

}  // namespace weft::render
