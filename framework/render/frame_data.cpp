#include "render/frame_data.h"

#include <algorithm>
#include <cmath>

#include "render/views/plain_light.h"
#include "scene/model/light_check.h"
#include "scene/model/sky_gradient.h"

namespace weft::render {
namespace {

static_assert(sizeof(shared::FrameConstants) == 240 && sizeof(shared::ViewConstants) == 512);
static_assert(sizeof(shared::Light) == 80 && sizeof(shared::LightFunction) == 64 &&
              sizeof(shared::Material) == 384 && sizeof(shared::Instance) == 208);

// A lamp can have doors (plates that limit its light). This is the largest angle in radians (89 degrees) at
// which a door limits the light. A door that is opened further has no effect.
constexpr float kSteepest_rad = 1.5533f;

shared::TextureTransform uv_of(const scene::TextureSlot& slot) {
    const glm::mat3x2& m = slot.transform;
    return {{m[0][0], m[1][0], m[2][0], static_cast<float>(slot.uv_set)}, {m[0][1], m[1][1], m[2][1], 0}};
}

// Returns the unit of the environment cube: a power of two by which its brightest texel is divided, so that
// the result is between 2^13 and 2^14. Half floats then have room for dark texels: their smallest normal
// number is 2^-14.
float cube_unit(float brightest) {
    if (!(brightest > 0)) return 1;
    return std::exp2(std::clamp(std::ceil(std::log2(brightest)) - 14.0f, -100.0f, 100.0f));
}

// Returns the share of ideally diffuse light that crosses a body with the optical depth `depth` (absorption ·
// thickness). The paths through the body have different lengths, so this is the mean over all directions: 2
// E3(depth), with the exponential integral E3. Source: Chandrasekhar 1960, "Radiative Transfer", appendix I.
float scattered_transmittance(float depth) {
    constexpr double kOpaque = 40;  // Less than 1e-18 of the light passes.
    const double x = depth;
    if (!(x > 0)) return 1;
    if (x > kOpaque) return 0;
    const double e1 = -std::expint(-x), e2 = std::exp(-x) - x * e1;
    return static_cast<float>(std::max(0.0, std::exp(-x) - x * e2));
}

// Returns A and B of the qualitative model of Oren and Nayar 1994 for the roughness σ in radians.
glm::vec2 oren_nayar(float sigma_rad) {
    const float s2 = sigma_rad * sigma_rad;
    return {1 - 0.5f * s2 / (s2 + 0.33f), 0.45f * s2 / (s2 + 0.09f)};
}

uint32_t gpu_light_type(scene::LightType type) {
    switch (type) {
        case scene::LightType::directional:
            return shared::kLightDirectional;
        case scene::LightType::point:
            return shared::kLightPoint;
        case scene::LightType::spot:
            return shared::kLightSpot;
        case scene::LightType::capsule:
            return shared::kLightCapsule;
        case scene::LightType::rectangle:
            return shared::kLightRectangle;
    }
    return shared::kLightPoint;
}

// Returns the sort key of a light. The order is: plain directional lights, other directional lights, other
// plain lights, all others. is_plain() says which lights are plain.
int rank(const shared::Light& light) {
    return (light.type == shared::kLightDirectional ? 0 : 2) + (is_plain(light) ? 0 : 1);
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
                                     uint32_t width_px, uint32_t height_px, const glm::vec2& jitter_px) {
    const float width = static_cast<float>(width_px), height = static_cast<float>(height_px);
    shared::ViewConstants view{};
    view.view = glm::inverse(camera.transform);
    view.projection = reversed_infinite_projection(camera.fov_y_rad, width / height, camera.near_m);
    view.steady_view_projection = view.projection * view.view;
    view.jitter_uv = jitter_px / glm::vec2(width, height);
    // The jitter moves the picture. Clip-space w is -z of view space, so an offset in the z column moves all
    // points by the same number of pixels, whatever their distance.
    view.projection[2] -= glm::vec4(2.0f * view.jitter_uv, 0, 0);
    view.view_projection = view.projection * view.view;
    // The matrix is inverted in double precision. The projection has no far plane; if the camera is also far
    // from the origin, float would lose too many digits.
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
    const scene::Environment& environment = scene.environment;
    if (!environment.mips.empty()) {
        frame.environment_scale = environment.scale;
        frame.environment_unit = cube_unit(environment.light.brightest);
        frame.environment_light_scale = environment.light.scale;
        for (size_t i = 0; i < environment.irradiance_over_pi.size(); ++i)
            frame.environment_irradiance_over_pi[i] = glm::vec4(environment.irradiance_over_pi[i], 0);
    }
    set_sky({scene.sky_zenith, scene.sky_horizon}, frame);
    return frame;
}

void set_sky(const SkyColors& sky, shared::FrameConstants& frame) {
    frame.sky_zenith = sky.zenith;
    frame.sky_horizon = sky.horizon;
    frame.sky_ground = sky.ground.value_or(sky.horizon * scene::kGroundAlbedo);
    if (frame.environment_scale > 0) return;  // The scene has an environment map, which sets the unit.
    const glm::vec3 brightest = glm::max(glm::max(frame.sky_zenith, frame.sky_horizon), frame.sky_ground);
    frame.environment_unit = cube_unit(std::max({brightest.r, brightest.g, brightest.b}));
}

shared::Light gpu_light(const scene::Light& scene_light, double time_s) {
    scene::Light light = scene_light;
    // light_warnings() reports the numbers that are clamped here, so the result is ignored.
    (void)scene::clamp_light(light);
    shared::Light gpu{};
    gpu.position = scene::position_at(light, time_s);
    gpu.range_m = light.range_m;
    gpu.intensity = light.color * light.intensity;
    gpu.type = gpu_light_type(light.type);
    gpu.direction = light.direction;
    if (light.type == scene::LightType::directional) {
        gpu.cone_scale = light.angular_radius_rad;  // disc_radius_rad() of lights.glsl reads cone_scale.
    } else {
        const float inner = std::cos(light.inner_cone_rad), outer = std::cos(light.outer_cone_rad);
        gpu.cone_scale = 1.0f / std::max(0.001f, inner - outer);
        gpu.cone_offset = -outer * gpu.cone_scale;
    }
    gpu.side = light.side;
    gpu.half_size_m = light.half_size_m;
    gpu.function = light.function == scene::kNone ? 0 : light.function + 1;
    return gpu;
}

std::vector<shared::Light> gpu_lights(std::span<const scene::Light> scene_lights, double time_s,
                                      size_t functions) {
    std::vector<shared::Light> lights;
    lights.reserve(scene_lights.size());
    for (const scene::Light& light : scene_lights) {
        const shared::Light gpu = gpu_light(light, time_s);
        if (std::max({gpu.intensity.r, gpu.intensity.g, gpu.intensity.b}) <= 0) continue;
        lights.push_back(gpu);
        if (gpu.function > functions) lights.back().function = 0;
    }
    std::ranges::stable_sort(lights, {}, rank);
    lights.resize(std::min<size_t>(lights.size(), scene::kMaxLights));
    for (uint32_t i = 0; i < std::min<size_t>(lights.size(), shared::kMostSuns); ++i)
        if (lights[i].type == shared::kLightDirectional) lights[i].shadow = i + 1;
    return lights;
}

shared::LightFunction gpu_light_function(const scene::LightFunction& scene_function) {
    scene::LightFunction function = scene_function;
    (void)scene::clamp_light_function(function);
    const auto length = [&](float x) {
        return function.parallel ? x : std::tan(std::clamp(x, -kSteepest_rad, kSteepest_rad));
    };
    const float open = function.parallel ? shared::kNoDoor : kSteepest_rad;
    shared::LightFunction gpu{};
    gpu.curve = function.curve;
    for (int i = 0; i < 4; ++i)
        gpu.doors[i] = function.doors[i] >= open ? shared::kNoDoor : length(function.doors[i]);
    gpu.picture_scale =
        1.0f / glm::vec2(length(function.picture_half_size.x), length(function.picture_half_size.y));
    gpu.reach_m = function.reach_m;
    gpu.softness = length(function.softness);
    return gpu;
}

shared::Material gpu_material(const scene::Material& m) {
    shared::Material gpu{};
    gpu.base_color = m.base_color;
    gpu.emissive = m.emissive;
    // The cutoff is set for all materials. It has an effect only in draws whose pipeline variant sets the
    // shader constant MASKED: only these discard pixels.
    gpu.alpha_cutoff = m.alpha_cutoff;
    const float r = (m.ior - 1) / (m.ior + 1);
    gpu.dielectric_f0 = glm::min(glm::vec3(r * r) * m.specular_color, glm::vec3(1));
    gpu.specular = m.specular;
    gpu.metallic = m.metallic;
    gpu.roughness = m.roughness;
    // The scale is 0 if the material has no normal map, so that the normal of the mesh is used unchanged.
    // Such a material gets a flat map of one texel, but the texel's value, 128/255, is not exactly 0.5.
    gpu.normal_scale = m.normal_texture.texture == scene::kNone ? 0.0f : m.normal_scale;
    gpu.occlusion_strength = m.occlusion_strength;
    gpu.base_color_uv = uv_of(m.base_color_texture);
    gpu.metallic_roughness_uv = uv_of(m.metallic_roughness_texture);
    gpu.normal_uv = uv_of(m.normal_texture);
    gpu.occlusion_uv = uv_of(m.occlusion_texture);
    gpu.emissive_uv = uv_of(m.emissive_texture);
    gpu.emission_tint = m.tinted_emission ? 1.0f : 0.0f;
    gpu.anisotropy = m.anisotropy;
    gpu.anisotropy_turn = {std::cos(m.anisotropy_rotation_rad), std::sin(m.anisotropy_rotation_rad)};
    gpu.anisotropy_uv = uv_of(m.anisotropy_texture);
    gpu.anisotropy_textured = m.anisotropy_texture.texture == scene::kNone ? 0.0f : 1.0f;
    gpu.two_sided = m.double_sided ? 1 : 0;
    gpu.transmission = m.transmission;
    gpu.absorption_per_m = m.absorption_per_m;
    gpu.thickness_m = m.thickness_m;
    gpu.ior = m.ior;
    gpu.ripples = m.ripples;
    gpu.clearcoat = m.clearcoat;
    gpu.clearcoat_roughness = m.clearcoat_roughness;
    gpu.diffuse_share = 1 - m.diffuse_transmission;
    gpu.transmitted_color = m.diffuse_transmission * m.diffuse_transmission_color;
    for (int i = 0; i < 3; ++i)
        gpu.transmitted_color[i] *= scattered_transmittance(m.absorption_per_m[i] * m.thickness_m);
    gpu.oren_nayar = oren_nayar(m.diffuse_roughness_rad);
    return gpu;
}

shared::Instance gpu_instance(const glm::mat4& transform) {
    const glm::mat3 linear(transform);
    // The cofactor matrix transforms normals. Unlike the inverse transpose, it also exists if the matrix is
    // singular. The sign of the determinant keeps normals on the outside of mirrored objects.
    const float sign = glm::determinant(linear) < 0 ? -1.0f : 1.0f;
    glm::mat4 normal(0.0f);
    normal[0] = glm::vec4(glm::cross(linear[1], linear[2]) * sign, 0);
    normal[1] = glm::vec4(glm::cross(linear[2], linear[0]) * sign, 0);
    normal[2] = glm::vec4(glm::cross(linear[0], linear[1]) * sign, 0);
    normal[3][3] = 1;
    return {transform, transform, normal, shared::kNoStream, shared::kNoStream, 0, 0};
}

}  // namespace weft::render
