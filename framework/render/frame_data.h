// Purpose: scene data in the form that shaders read: views, frame constants, lights, materials. Pure
// functions. Units and layouts: shaders/include/shared/.
#pragma once

#include <span>
#include <vector>

#include "shared/frame.glsl"
#include "shared/instance.glsl"
#include "shared/light.glsl"
#include "shared/light_function.glsl"
#include "shared/material.glsl"
#include "weft/scene/scene.h"

namespace weft::render {

// Clip space with y down and reversed depth: 1 at near_m, 0 at infinity. `aspect` is width / height.
[[nodiscard]] glm::mat4 reversed_infinite_projection(float fov_y_rad, float aspect, float near_m);

// `jitter_px` moves the picture by this many pixels, right and down. `prev_view_projection` must contain no
// jitter.
[[nodiscard]] shared::ViewConstants view_constants(const scene::Camera& camera,
                                                   const glm::mat4& prev_view_projection, uint32_t width_px,
                                                   uint32_t height_px, const glm::vec2& jitter_px = {0, 0});

// The constants that are the same in every frame: the sky or the environment.
[[nodiscard]] shared::FrameConstants scene_constants(const scene::Scene& scene);

// Clamps numbers that are out of range: see scene/light_check.h.
[[nodiscard]] shared::Light gpu_light(const scene::Light& light, double time_s = 0);
// Without area and function.
[[nodiscard]] bool is_plain(const shared::Light& light);
// Lights with an intensity, at most kMaxLights: directional ones first, within each kind the plain ones
// first, otherwise in the scene's order, so that a full buffer omits the last ones. A light whose function is
// not in `functions` has none. The first directional light casts the sun's shadows.
[[nodiscard]] std::vector<shared::Light> gpu_lights(std::span<const scene::Light> lights, double time_s,
                                                    size_t functions = 0);
// Does not fill in its picture.
[[nodiscard]] shared::LightFunction gpu_light_function(const scene::LightFunction& function);

[[nodiscard]] shared::Material gpu_material(const scene::Material& material);
// For a mesh without vertex colours and second uvs.
[[nodiscard]] shared::Instance gpu_instance(const glm::mat4& transform);

}  // namespace weft::render
