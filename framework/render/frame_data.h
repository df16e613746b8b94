// Purpose: converts scene data to the form that shaders read: views, frame constants, lights, materials. Pure
// functions. Units and layouts: shaders/include/shared/.
#pragma once

#include <span>
#include <vector>

#include "shared/frame.glsl"
#include "shared/instance.glsl"
#include "shared/light.glsl"
#include "shared/light_function.glsl"
#include "shared/material.glsl"
#include "weft/render/frame_input.h"
#include "weft/scene/scene.h"

namespace weft::render {

// Returns a projection matrix. Its clip space has y down and reversed depth: 1 at the distance near_m, 0 at
// infinity. `aspect` is width / height.
[[nodiscard]] glm::mat4 reversed_infinite_projection(float fov_y_rad, float aspect, float near_m);

// Returns the constants of the camera's view. `jitter_px` moves the picture by this many pixels, to the right
// and down. `prev_view_projection` must contain no jitter.
[[nodiscard]] shared::ViewConstants view_constants(const scene::Camera& camera,
                                                   const glm::mat4& prev_view_projection, uint32_t width_px,
                                                   uint32_t height_px, const glm::vec2& jitter_px = {0, 0});

// Returns the constants that are the same in every frame: the colours of the sky, and the scale and
// irradiance of the environment.
[[nodiscard]] shared::FrameConstants scene_constants(const scene::Scene& scene);

// Sets the colours of the sky.
void set_sky(const SkyColors& sky, shared::FrameConstants& frame);

// Converts a light, at its position at time `time_s`. Numbers that are out of range are clamped: see
// scene/light_check.h.
[[nodiscard]] shared::Light gpu_light(const scene::Light& light, double time_s = 0);
// Returns the lights with an intensity above 0, at most kMaxLights. The order is: plain directional lights
// (see views/plain_light.h), other directional lights, other plain lights, all others. Within each of these
// groups the scene's order is kept. If the graph's light buffer is too small, light_upload later drops the
// last lights. `functions` is the number of light functions. A light whose function does not exist gets no
// function. The first directional light casts the sun's shadows.
[[nodiscard]] std::vector<shared::Light> gpu_lights(std::span<const scene::Light> lights, double time_s,
                                                    size_t functions = 0);
// Converts a light function, but leaves the index of its picture at 0 (no picture).
[[nodiscard]] shared::LightFunction gpu_light_function(const scene::LightFunction& function);

[[nodiscard]] shared::Material gpu_material(const scene::Material& material);
// Converts the transform of an object. Both vertex stream offsets of the result are kNoStream: they are right
// for a mesh that has neither vertex colours nor second uvs.
[[nodiscard]] shared::Instance gpu_instance(const glm::mat4& transform);

}  // namespace weft::render
