// Purpose: describes a scene as plain data, made from a glTF file or by code. It contains no Vulkan objects
// and no file handles. Units: metres, radians, photometric units (candela for point and spot lights, lux for
// directional lights, cd/m² for capsules and rectangles). Axes: as in glTF, y up, right-handed, front faces
// counter-clockwise. Colours: scene-linear Rec.709.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "weft/scene/environment.h"
#include "weft/scene/motion.h"
#include "weft/scene/probes.h"

namespace weft::scene {

struct Bounds {
    glm::vec3 min{0};
    glm::vec3 max{0};
};

// One indexed triangle list. Each list of vertex data has one element for each vertex, as `positions` has;
// `colors` and `second_uvs` may be empty.
struct Mesh {
    std::string name;
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;
    // xyz is the tangent T. w is the sign of the bitangent B: B = cross(N, T) * w.
    std::vector<glm::vec4> tangents;
    std::vector<glm::vec2> uvs;
    std::vector<uint32_t> indices;  // Indices of vertices, three for each triangle.
    // Factors for base colour and alpha in [0, 1], one for each vertex; empty: all factors are 1.
    std::vector<glm::vec4> colors;
    // Texture coordinates for slots with uv_set 1, one for each vertex; empty: these slots use `uvs`.
    std::vector<glm::vec2> second_uvs;
    Bounds bounds;
};

enum class ColorSpace : uint8_t { linear, srgb };
enum class Filter : uint8_t { nearest, linear };
enum class Wrap : uint8_t { repeat, mirrored_repeat, clamp_to_edge };

// A picture with four 8-bit channels and a full mip chain. Mip 0 is the first; each mip has half the size of
// the previous one, rounded down, but at least 1.
struct Texture {
    std::string name;
    uint32_t width_px = 1;
    uint32_t height_px = 1;
    ColorSpace color_space = ColorSpace::linear;
    std::vector<std::vector<uint8_t>> mips;
};

// A texture with the sampler that reads it, and KHR_texture_transform as a matrix: uv' = transform * (u, v,
// 1).
struct TextureSlot {
    uint32_t texture = kNone;
    Filter mag = Filter::linear;
    Filter min = Filter::linear;
    bool mipmapped = true;
    Wrap wrap_u = Wrap::repeat;
    Wrap wrap_v = Wrap::repeat;
    uint32_t uv_set = 0;  // Set of texture coordinates: 0: Mesh::uvs, 1: Mesh::second_uvs.
    // Transforms (u, v, 1). The columns of the matrix are the factor of u, the factor of v, and the offset.
    glm::mat3x2 transform{1, 0, 0, 1, 0, 0};
};

enum class AlphaMode : uint8_t { opaque, mask, blend };

struct Material {
    std::string name;
    glm::vec4 base_color{1};
    float metallic = 1;
    float roughness = 1;    // Perceptual roughness, as in glTF.
    glm::vec3 emissive{0};  // Emitted light in cd/m², already multiplied by KHR_materials_emissive_strength.
    bool tinted_emission = false;  // True: vertex colours also multiply `emissive`, as for unlit materials.
    float normal_scale = 1;
    float occlusion_strength = 1;
    float specular = 1;           // specularFactor of KHR_materials_specular.
    glm::vec3 specular_color{1};  // specularColorFactor of KHR_materials_specular.
    float ior = 1.5f;
    AlphaMode alpha_mode = AlphaMode::opaque;
    float alpha_cutoff = 0.5f;
    bool double_sided = false;
    TextureSlot base_color_texture;          // Base colour and alpha, encoded as sRGB.
    TextureSlot metallic_roughness_texture;  // Linear: channel g is roughness, channel b is metalness.
    TextureSlot normal_texture;              // Normal map, linear.
    TextureSlot occlusion_texture;           // Linear: channel r is occlusion.
    TextureSlot emissive_texture;            // Emitted light, encoded as sRGB.
    // KHR_materials_anisotropy. `anisotropy` is the strength: additional roughness along the tangent. The
    // tangent is rotated counter-clockwise about the normal by anisotropy_rotation_rad.
    float anisotropy = 0;
    float anisotropy_rotation_rad = 0;
    // Linear: channels rg are the direction, channel b is a factor for the strength.
    TextureSlot anisotropy_texture;
    // KHR_materials_clearcoat: a thin layer with an index of refraction of 1.5 on top of the surface.
    // `clearcoat` is the share of the surface that it covers, 0 to 1.
    float clearcoat = 0;
    float clearcoat_roughness = 0;
    // KHR_materials_transmission and KHR_materials_volume. Of the light that the surface does not mirror, the
    // share `transmission` (0 to 1) passes through it. Behind the surface lies a body with this thickness,
    // measured along the normal; 0: a thin sheet, which refracts and absorbs nothing. Along the distance d,
    // the body lets exp(−absorption_per_m · d) of the light pass. A material with a transmission above 0 has
    // the alpha mode `blend`.
    float transmission = 0;
    float thickness_m = 0;
    glm::vec3 absorption_per_m{0};
    // KHR_materials_diffuse_transmission. Of the light that the surface does not mirror, the share
    // `diffuse_transmission` (0 to 1) passes through it with this colour and is scattered. If thickness_m is
    // above 0, this light crosses the body, which absorbs a part of it.
    float diffuse_transmission = 0;
    glm::vec3 diffuse_transmission_color{1};
    // Roughness σ of the diffuse reflection: the standard deviation of the slopes of small facets, in
    // radians. A surface with a large σ looks flat, like plaster or the moon (Oren and Nayar 1994). 0:
    // ideally diffuse.
    float diffuse_roughness_rad = 0;
    // If it is not 0, the normal map is used as two layers of ripples that move. xy and zw: their velocities
    // in texture coordinates per second. The second layer is rotated by 90°.
    glm::vec4 ripples{0};
};

struct Instance {
    std::string name;
    uint32_t mesh = 0;
    uint32_t material = 0;
    // Transforms object space to world space. If the determinant is negative, the winding is reversed. A
    // moving instance has its transform at time 0 here.
    glm::mat4 transform{1};
    uint32_t node = kNone;  // The node of Scene::motion that moves the instance; kNone: it does not move.
};

enum class LightType : uint8_t { directional, point, spot, capsule, rectangle };

// A closed path on which a light moves around its position. At time `seconds` the light is at position +
// across · cos(2π t) + along · sin(2π t), where t = phase + turns_per_s · seconds.
struct LightPath {
    glm::vec3 across{0};
    glm::vec3 along{0};
    float turns_per_s = 0;  // Number of turns per second; 0: the light does not move.
    float phase = 0;
};

// Shapes the light of a lamp with barn doors, a picture (gobo) and a falloff curve. Doors, softness and
// picture are measured in radians from the direction of the lamp; for parallel light, in metres.
struct LightFunction {
    static constexpr float kNoDoor = 1e9f;

    std::string name;
    bool parallel = false;  // True for directional lights, whose rays are parallel.
    // Positions of the four barn doors: left, right, bottom, top. Each is measured from the direction of the
    // lamp to the edge of the door. Light beyond the edge is blocked. kNoDoor: no door.
    glm::vec4 doors{kNoDoor};
    // Width of the transition from light to dark at the edge of a door. The picture is blurred by the same
    // width.
    float softness = 0.01f;
    // Picture: an index into Scene::textures; kNone: no picture. For a point light the picture covers the
    // whole sphere.
    uint32_t picture = kNone;
    // Half width and half height of the picture in radians; for parallel light, in metres.
    glm::vec2 picture_half_size{0.7853981634f};
    // Falloff curve: a factor on the light, as a cubic Bézier curve over the distance from 0 to `reach_m`.
    // `curve` has the four ordinates. Beyond `reach_m` the factor is constant.
    glm::vec4 curve{1};
    float reach_m = 1;
};

struct Light {
    std::string name;
    LightType type = LightType::point;
    glm::vec3 color{1};
    // Intensity in cd for point and spot lights, in lx for directional lights, in cd/m² for capsules and
    // rectangles.
    float intensity = 1;
    glm::vec3 position{0};
    // Direction in which the light travels; for a capsule, its axis. Unit length.
    glm::vec3 direction{0, 0, -1};
    float range_m = 0;         // Distance in metres at which the light ends; 0: unlimited.
    float inner_cone_rad = 0;  // Half the angle of the bright inner cone; for spot lights only.
    float outer_cone_rad = 0.7853981634f;
    LightPath path;
    // The direction of the width of a rectangle, and of doors and pictures. 0: any vector perpendicular to
    // `direction` is used.
    glm::vec3 side{0};
    // Size of the light. Rectangle: half width and half height. Capsule: half length without the caps, and
    // radius.
    glm::vec2 half_size_m{0};
    // Directional lights: angular radius of the disc from which the light comes; 0: the light is parallel.
    float angular_radius_rad = 0;
    // Light function: an index into Scene::light_functions; kNone: no light function.
    uint32_t function = kNone;
    uint32_t node = kNone;  // The node of Scene::motion that moves the light; kNone: only `path` moves it.
};

// A camera with perspective projection. It looks along −z of `transform`; y is up.
struct Camera {
    std::string name;
    glm::mat4 transform{1};  // Transforms camera space to world space. It contains no scale.
    float fov_y_rad = 0.8f;
    float near_m = 0.05f;
    uint32_t node = kNone;  // The node of Scene::motion that moves the camera; kNone: it does not move.
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
    Motion motion;
    Bounds bounds;  // Bounding box of all instances, in world space, at time 0.
    // Radiance of the sky at the zenith in cd/m². It changes gradually to sky_horizon at the horizon. Both
    // are 0 with `--env none`.
    glm::vec3 sky_zenith{0};
    glm::vec3 sky_horizon{0};
    Probes probes;            // The probes that the author of the scene placed.
    Environment environment;  // Picture of the surroundings. If the scene has one, it replaces the sky.
    // An exposure in EV that suits this scene; 0 means that radiance is multiplied by 1.
    float exposure_ev = 0;
    // Memory of the scene and of its copy on the GPU, as counted for SceneLimits::memory_bytes.
    uint64_t memory_bytes = 0;
};

[[nodiscard]] glm::vec3 position_at(const Light& light, double time_s);

[[nodiscard]] Bounds world_bounds(const Scene& scene);
// Returns the world bounds of the instances that do not move; nullopt if none of them has a vertex.
[[nodiscard]] std::optional<Bounds> fixed_bounds(const Scene& scene);

// Returns a camera for a scene that has none. It looks at the centre of the bounds from the direction (0.9,
// 0.75, 1.3), normalised, at a distance of 1.9 × the bounding radius. `aspect` is width / height. If `aspect`
// is 1 or more, the horizontal field of view is 45°. If it is less, the horizontal field of view is 63.5°, so
// that the picture contains the whole bounding sphere.
[[nodiscard]] Camera framing_camera(const Scene& scene, float aspect);

}  // namespace weft::scene
