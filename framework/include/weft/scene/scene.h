// Purpose: a scene as plain data, from glTF or from code. No Vulkan, no file handles. Units: metres, radians,
// photometric units (candela for point and spot lights, lux for directional ones, cd/m² for capsules and
// rectangles). Axes: as in glTF, y up, right-handed, front faces counter-clockwise. Colours: scene-linear
// Rec.709.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "weft/scene/environment.h"

namespace weft::scene {

inline constexpr uint32_t kNone = UINT32_MAX;

struct Bounds {
    glm::vec3 min{0};
    glm::vec3 max{0};
};

// One indexed triangle list. Every stream has as many elements as `positions`; the last two streams may be
// empty.
struct Mesh {
    std::string name;
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;
    std::vector<glm::vec4> tangents;  // xyz, w = sign of the bitangent: B = cross(N, T) * w
    std::vector<glm::vec2> uvs;
    std::vector<uint32_t> indices;      // three per triangle
    std::vector<glm::vec4> colors;      // factor for base colour and alpha, in [0, 1]; empty: 1 everywhere
    std::vector<glm::vec2> second_uvs;  // for slots whose uv_set is 1; empty: these slots use `uvs`
    Bounds bounds;
};

enum class ColorSpace : uint8_t { linear, srgb };
enum class Filter : uint8_t { nearest, linear };
enum class Wrap : uint8_t { repeat, mirrored_repeat, clamp_to_edge };

// Four 8-bit channels; the full mip chain, mip 0 first, each mip max(1, w/2) × max(1, h/2).
struct Texture {
    std::string name;
    uint32_t width_px = 1;
    uint32_t height_px = 1;
    ColorSpace color_space = ColorSpace::linear;
    std::vector<std::vector<uint8_t>> mips;
};

// A reference to a texture with its sampler, and KHR_texture_transform as uv' = matrix * (u, v, 1).
struct TextureSlot {
    uint32_t texture = kNone;
    Filter mag = Filter::linear;
    Filter min = Filter::linear;
    bool mipmapped = true;
    Wrap wrap_u = Wrap::repeat;
    Wrap wrap_v = Wrap::repeat;
    uint32_t uv_set = 0;                      // 1: uses Mesh::second_uvs
    glm::mat3x2 transform{1, 0, 0, 1, 0, 0};  // columns: u, v, offset
};

enum class AlphaMode : uint8_t { opaque, mask, blend };

struct Material {
    std::string name;
    glm::vec4 base_color{1};
    float metallic = 1;
    float roughness = 1;           // perceptual roughness
    glm::vec3 emissive{0};         // cd/m² after KHR_materials_emissive_strength
    bool tinted_emission = false;  // vertex colours also multiply `emissive`, as for unlit surfaces
    float normal_scale = 1;
    float occlusion_strength = 1;
    float specular = 1;           // KHR_materials_specular: specularFactor
    glm::vec3 specular_color{1};  // specularColorFactor
    float ior = 1.5f;
    AlphaMode alpha_mode = AlphaMode::opaque;
    float alpha_cutoff = 0.5f;
    bool double_sided = false;
    TextureSlot base_color_texture;          // sRGB
    TextureSlot metallic_roughness_texture;  // linear: g roughness, b metalness
    TextureSlot normal_texture;              // linear
    TextureSlot occlusion_texture;           // linear: r
    TextureSlot emissive_texture;            // sRGB
    // KHR_materials_anisotropy: additional roughness along the tangent, which is rotated counter-clockwise
    // about the normal.
    float anisotropy = 0;
    float anisotropy_rotation_rad = 0;
    TextureSlot anisotropy_texture;  // linear: rg is the direction, b a factor for the strength
};

struct Instance {
    std::string name;
    uint32_t mesh = 0;
    uint32_t material = 0;
    glm::mat4 transform{1};  // object to world; a negative determinant reverses the winding
};

enum class LightType : uint8_t { directional, point, spot, capsule, rectangle };

// A closed path around a light's position: position + across · cos(2π t) + along · sin(2π t), where t is
// phase + turns_per_s · seconds.
struct LightPath {
    glm::vec3 across{0};
    glm::vec3 along{0};
    float turns_per_s = 0;  // 0: the light does not move
    float phase = 0;
};

// Shapes the light of a lamp: doors, a picture (gobo), a falloff curve. Doors, softness and picture are
// measured in radians from the direction of the lamp, or in metres for parallel light.
struct LightFunction {
    static constexpr float kNoDoor = 1e9f;

    std::string name;
    bool parallel = false;     // true for directional lights
    glm::vec4 doors{kNoDoor};  // limits of the light towards −width, +width, −up and +up
    float softness = 0.01f;    // width of the transition at a door's edge; the picture is blurred by the same
                               // width
    uint32_t picture = kNone;  // index into Scene::textures; for a point light the picture covers the whole
                               // sphere
    glm::vec2 picture_half_size{0.7853981634f};
    glm::vec4 curve{1};  // Bézier ordinates of a factor over the distance from 0 to `reach_m`; constant
                         // beyond
    float reach_m = 1;
};

struct Light {
    std::string name;
    LightType type = LightType::point;
    glm::vec3 color{1};
    float intensity = 1;  // cd for point and spot, lx for directional, cd/m² for capsule and rectangle
    glm::vec3 position{0};
    glm::vec3 direction{0, 0, -1};  // direction in which the light travels; for a capsule its axis. Unit
                                    // length
    float range_m = 0;              // 0: unlimited
    float inner_cone_rad = 0;       // half angles, spot only
    float outer_cone_rad = 0.7853981634f;
    LightPath path;
    // The width axis of a rectangle, of doors and pictures; for a capsule the direction of its doors and
    // pictures. 0: any vector perpendicular to `direction`.
    glm::vec3 side{0};
    // Rectangle: half width, half height. Capsule: half length without the caps, radius.
    glm::vec2 half_size_m{0};
    uint32_t function = kNone;  // index into Scene::light_functions
};

// Perspective only. It looks along -z of `transform`, y up.
struct Camera {
    std::string name;
    glm::mat4 transform{1};  // camera to world, no scale
    float fov_y_rad = 0.8f;
    float near_m = 0.05f;
};

struct Scene {
    std::string name;
    std::vector<Mesh> meshes;
    std::vector<Texture> textures;
    std::vector<Material> materials;
    std::vector<Instance> instances;
    std::vector<Light> lights;
    std::vector<LightFunction> light_functions;
    std::vector<Camera> cameras;
    Bounds bounds;            // of all instances, in world space
    glm::vec3 sky_zenith{0};  // background radiance in cd/m², as a gradient; 0 with --env none
    glm::vec3 sky_horizon{0};
    Environment environment;  // if present, replaces the sky
    float exposure_ev = 0;    // a suitable exposure for this scene; 0 means factor 1
    uint64_t memory_bytes =
        0;  // memory of the scene and its copy on the GPU, counted for SceneLimits::memory_bytes
};

[[nodiscard]] glm::vec3 position_at(const Light& light, double time_s);

[[nodiscard]] Bounds world_bounds(const Scene& scene);

// The default camera for a scene without one: it looks at the bounds' centre from direction (0.9, 0.75, 1.3),
// normalised, at 1.9 × the bounding radius. `aspect` is width / height. For aspects of 1 and above the
// horizontal field of view is 45°; below, it is 63.5°, which contains the whole bounding sphere.
[[nodiscard]] Camera framing_camera(const Scene& scene, float aspect);

}  // namespace weft::scene
