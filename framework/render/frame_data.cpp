#include "render/frame_data.h"

#include <algorithm>
#include <cmath>

namespace weft::render {
namespace {

static_assert(sizeof(shared::FrameConstants) == 208 && sizeof(shared::ViewConstants) == 352);
static_assert(sizeof(shared::Light) == 64 && sizeof(shared::Material) == 224 &&
              sizeof(shared::Instance) == 192);

// What the ground below the horizon sends up: daylight on something of a quarter's albedo.
constexpr float kGroundAlbedo = 0.25f;

shared::TextureTransform rows(const glm::mat3x2& m) {
    return {{m[0][0], m[1][0], m[2][0], 0}, {m[0][1], m[1][1], m[2][1], 0}};
}

uint32_t gpu_light_type(scene::LightType type) {
    switch (type) {
        case scene::LightType::directional:
            return shared::kLightDirectional;
        case scene::LightType::point:
            return shared::kLightPoint;
        case scene::LightType::spot:
            return shared::kLightSpot;
    }
    return shared::kLightPoint;
}

}  // namespace

glm::mat4 reversed_infinite_projection(float fov_y_rad, float aspect, float near_m) {
    const float f = 1.0f / std::tan(fov_y_rad * 0.5f);
    glm::mat4 projection(0.0f);
    projection[0][0] = f / aspect;
    projection[1][1] = -f;
    projection[2][3] = -1;
    projection[3][2] = near_m;
    return projection;
}

shared::ViewConstants view_constants(const scene::Camera& camera, const glm::mat4& prev_view_projection,
                                     uint32_t width_px, uint32_t height_px) {
    const float width = static_cast<float>(width_px), height = static_cast<float>(height_px);
    shared::ViewConstants view;
    view.view = glm::inverse(camera.transform);
    view.projection = reversed_infinite_projection(camera.fov_y_rad, width / height, camera.near_m);
    view.view_projection = view.projection * view.view;
    // Inverted in double: an infinite projection far from the origin loses too much in float.
    view.inverse_view_projection =
        glm::mat4(glm::inverse(glm::dmat4(view.projection) * glm::dmat4(view.view)));
    view.prev_view_projection = prev_view_projection;
    view.eye = glm::vec3(camera.transform[3]);
    view.near_m = camera.near_m;
    view.viewport_px = {width, height};
    view.inverse_viewport = {1 / width, 1 / height};
    return view;
}

shared::FrameConstants scene_constants(const scene::Scene& scene) {
    shared::FrameConstants frame{};
    frame.sky_zenith = scene.sky_zenith;
    frame.sky_horizon = scene.sky_horizon;
    frame.sky_ground = scene.sky_horizon * kGroundAlbedo;
    frame.light_count = static_cast<uint32_t>(scene.lights.size());
    if (scene.environment.mips.empty()) return frame;
    frame.environment_scale = scene.environment.scale;
    for (size_t i = 0; i < scene.environment.irradiance_over_pi.size(); ++i)
        frame.environment_irradiance_over_pi[i] = glm::vec4(scene.environment.irradiance_over_pi[i], 0);
    return frame;
}

shared::Light gpu_light(const scene::Light& light) {
    shared::Light gpu{};
    gpu.position = light.position;
    gpu.range_m = light.range_m;
    gpu.intensity = light.color * light.intensity;
    gpu.type = gpu_light_type(light.type);
    gpu.direction = light.direction;
    const float inner = std::cos(light.inner_cone_rad), outer = std::cos(light.outer_cone_rad);
    gpu.cone_scale = 1.0f / std::max(0.001f, inner - outer);
    gpu.cone_offset = -outer * gpu.cone_scale;
    return gpu;
}

std::vector<shared::Light> gpu_lights(const scene::Scene& scene) {
    std::vector<shared::Light> lights;
    lights.reserve(scene.lights.size());
    for (const scene::Light& light : scene.lights) lights.push_back(gpu_light(light));
    std::stable_partition(lights.begin(), lights.end(),
                          [](const shared::Light& light) { return light.type == shared::kLightDirectional; });
    return lights;
}

shared::Material gpu_material(const scene::Material& m) {
    shared::Material gpu{};
    gpu.base_color = m.base_color;
    gpu.emissive = m.emissive;
    // Only masked materials discard, and only in their own draw list.
    gpu.alpha_cutoff = m.alpha_cutoff;
    const float r = (m.ior - 1) / (m.ior + 1);
    gpu.dielectric_f0 = glm::min(glm::vec3(r * r) * m.specular_color, glm::vec3(1));
    gpu.specular = m.specular;
    gpu.metallic = m.metallic;
    gpu.roughness = m.roughness;
    // 128/255 is not quite the middle: without a normal map the geometry's normal must come through
    // untouched.
    gpu.normal_scale = m.normal_texture.texture == scene::kNone ? 0.0f : m.normal_scale;
    gpu.occlusion_strength = m.occlusion_strength;
    gpu.base_color_uv = rows(m.base_color_texture.transform);
    gpu.metallic_roughness_uv = rows(m.metallic_roughness_texture.transform);
    gpu.normal_uv = rows(m.normal_texture.transform);
    gpu.occlusion_uv = rows(m.occlusion_texture.transform);
    gpu.emissive_uv = rows(m.emissive_texture.transform);
    return gpu;
}

shared::Instance gpu_instance(const glm::mat4& transform) {
    const glm::mat3 linear(transform);
    // Columns of the cofactor matrix: exact for any scale, singular ones included. The determinant's sign
    // keeps normals on the outside of mirrored objects.
    const float sign = glm::determinant(linear) < 0 ? -1.0f : 1.0f;
    glm::mat4 normal(0.0f);
    normal[0] = glm::vec4(glm::cross(linear[1], linear[2]) * sign, 0);
    normal[1] = glm::vec4(glm::cross(linear[2], linear[0]) * sign, 0);
    normal[2] = glm::vec4(glm::cross(linear[0], linear[1]) * sign, 0);
    normal[3][3] = 1;
    return {transform, transform, normal};
}

}  // namespace weft::render
