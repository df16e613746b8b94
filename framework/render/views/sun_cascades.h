// Purpose: computes the projections of the sun's shadow maps. The sun is the first directional light of a
// scene. Each map (cascade) covers the camera's view between two distances from the eye, in a parallel
// projection along the light. A map covers a sphere around its part of the view, so the size of the map does
// not change when the camera rotates. A map moves by whole texels only, so static shadows do not flicker. In
// the direction of the sun, every map covers the whole scene, so no shadow caster is missed. Pure functions
// in double precision. Units: metres, texels. Source: Zhang et al. 2006, "Parallel-Split Shadow Maps for
// Large-Scale Virtual Environments" (the splits); Valient 2007, "Stable Rendering of Cascaded Shadow Maps",
// ShaderX6 (spheres, whole texels).
#pragma once

#include <array>
#include <string>

#include "shared/frame.glsl"
#include "shared/sun.glsl"
#include "weft/plan.h"
#include "weft/scene/scene.h"

namespace weft::render {

// The number of sun views that a graph draws, and the side of each shadow map in texels.
struct SunMaps {
    uint32_t count = 0;
    std::array<uint32_t, shared::kMostSunCascades> size_px{};
};
// Returns the name of the view for a cascade, such as "sun(2)".
[[nodiscard]] std::string sun_view_name(uint32_t cascade);
// Returns the sun views that the passes of a plan draw. If several passes draw a view at different sizes, the
// largest size is used.
[[nodiscard]] SunMaps sun_maps_of(const FramePlan& plan);

struct SunScene {
    // Unit vector from the scene towards the sun.
    glm::vec3 to_sun{0, 1, 0};
    // Bounds of all objects that cast or receive shadows.
    scene::Bounds bounds;
};

// One shadow map: the sphere that the map must cover, and the square of texels that covers this sphere in a
// parallel projection along the light.
struct SunCascade {
    glm::dvec3 center{0};
    double radius_m = 0;
    // The map is used up to this distance from the eye, in metres. Infinite for the last map if it covers the
    // whole scene.
    double end_m = 0;
    double texel_m = 0;
    // Position of the map's upper left corner on the plane perpendicular to the light, in whole texels.
    glm::dvec2 origin_texels{0};
};

// Splits the range from near_m to far_m into `count` parts and returns their ends, in metres. Each end is the
// weighted mean of two values: the end if all parts had the same ratio of far to near distance, and the end
// if all parts had the same length. The last end is `far_m`.
[[nodiscard]] std::array<double, shared::kMostSunCascades> split_distances(double near_m, double far_m,
                                                                           uint32_t count);

struct SunCascades {
    uint32_t count = 0;
    std::array<SunCascade, shared::kMostSunCascades> cascades;
    shared::SunConstants constants{};
    // Element i has the view constants for passes with the view "sun(i)".
    std::array<shared::ViewConstants, shared::kMostSunCascades> views{};
};
// Computes all shadow maps of the sun for one camera. `aspect` is width / height of the picture.
[[nodiscard]] SunCascades sun_cascades(const scene::Camera& camera, float aspect, const SunScene& scene,
                                       const SunMaps& maps);

}  // namespace weft::render
