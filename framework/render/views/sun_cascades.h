// Purpose: computes the projections of the sun's shadow maps. The sun is the first directional light of a
// scene. Each map (cascade) is a parallel projection along the light. The last map covers the whole scene, or
// the part of the scene that has shadows. The other maps fit the surfaces that the camera sees. A map moves
// by whole texels only, and its texels change their size only in steps, so static shadows do not flicker. In
// the direction of the sun, every map covers the whole scene, so no shadow caster is missed. Pure functions
// in double precision. Units: metres, texels. Source: Lauritzen, Salvi, Lefohn 2011, "Sample Distribution
// Shadow Maps" (maps that fit the visible surfaces); Valient 2007, "Stable Rendering of Cascaded Shadow
// Maps", ShaderX6 (whole texels).
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "render/views/light_space.h"
#include "render/views/surface_tree.h"
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
    // The surfaces of the objects that do not move. Each tree must exist until sun_cascades() returns.
    std::vector<const SurfaceTree*> surfaces;
    // Bounds of objects about which nothing else is known, if there are any.
    std::optional<scene::Bounds> unknown;
    // True if there are objects that may be anywhere.
    bool is_unbounded = false;
};

// One shadow map: the rectangle that the map must cover, in the plane perpendicular to the light, and the
// texels that cover this rectangle.
struct SunCascade {
    LightRect rect;
    // Width and height of a texel.
    glm::dvec2 texel_m{0};
    // Position of the map's upper left corner on the plane, in whole texels.
    glm::dvec2 origin_texels{0};
};

struct SunCascades {
    uint32_t count = 0;
    std::array<SunCascade, shared::kMostSunCascades> cascades;
    shared::SunConstants constants{};
    // Element i has the view constants for passes with the view "sun(i)".
    std::array<shared::ViewConstants, shared::kMostSunCascades> views{};
};
// Computes all shadow maps of the sun for one camera. `aspect` is width / height of the picture. The maps
// before the last are in the order of the areas that they cover, the smallest first: a point uses the first
// map that contains it.
[[nodiscard]] SunCascades sun_cascades(const scene::Camera& camera, float aspect, const SunScene& scene,
                                       const SunMaps& maps);

// Calls sun_cascades() only if its result changes.
class SunCascadesCache {
 public:
    // `surfaces_version` changes whenever the list SunScene::surfaces changes.
    [[nodiscard]] const SunCascades& find(const scene::Camera& camera, float aspect, const SunScene& scene,
                                          const SunMaps& maps, uint64_t surfaces_version);

 private:
    // All values on which the result depends, except the surfaces. The values of the camera are those of
    // rounded_camera().
    std::vector<float> key_;
    uint64_t surfaces_version_ = 0;
    SunCascades cascades_;
};

}  // namespace weft::render
