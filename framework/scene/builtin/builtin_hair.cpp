#include "scene/builtin/builtin_hair.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "scene/builtin/scene_parts.h"
#include "scene/model/angles.h"
#include "scene/pictures/mip_chain.h"
#include "scene/procedural/procedural_mesh.h"
#include "scene/procedural/procedural_noise.h"

namespace weft::scene {
namespace {

constexpr float kHeadRadius = 0.3f;
constexpr float kHeadHeight = 0.86f;
constexpr uint32_t kRibbons = 900;
constexpr uint32_t kSteps = 12;
constexpr float kStep_m = 0.058f;
// Where alpha is at least this, hair is opaque. The tips have a smaller alpha.
constexpr float kOpaqueAlpha = 0.9f;

// Adds a texture of a ribbon of hair: parallel strands with different colours, of which each ends in a
// transparent tip at another length. The lower edge of the texture is the end of the hair.
uint32_t add_strands_texture(Scene& scene) {
    constexpr uint32_t kWidth = 64, kHeight = 256, kStrands = 16;
    Random random(7);
    struct Strand {
        float shade, end;
    };
    std::vector<Strand> strands;
    for (uint32_t i = 0; i < kStrands; ++i)
        strands.push_back({random.range(0.65f, 1.15f), random.range(0.55f, 1)});
    std::vector<uint8_t> texels;
    for (uint32_t y = 0; y < kHeight; ++y) {
        for (uint32_t x = 0; x < kWidth; ++x) {
            const float along = (static_cast<float>(y) + 0.5f) / kHeight;
            const Strand& strand = strands[x * kStrands / kWidth];
            const float across =
                2 * (static_cast<float>(x % (kWidth / kStrands)) + 0.5f) / (kWidth / kStrands) - 1;
            const float left = std::clamp((strand.end - along) / (0.45f * strand.end), 0.0f, 1.0f);
            const float alpha = std::clamp(left * 1.6f, 0.0f, 1.0f) * (1 - 0.08f * across * across);
            const glm::vec3 color = glm::vec3(0.46f, 0.29f, 0.17f) * strand.shade * (0.75f + 0.4f * along);
            for (const float channel : {color.r, color.g, color.b, alpha})
                texels.push_back(static_cast<uint8_t>(std::lround(std::clamp(channel, 0.0f, 1.0f) * 255)));
        }
    }
    Texture texture;
    texture.name = "hair";
    texture.width_px = kWidth;
    texture.height_px = kHeight;
    texture.color_space = ColorSpace::srgb;
    texture.mips = build_mip_chain(kWidth, kHeight, std::move(texels), {TexelMeaning::srgb_color, -1});
    scene.textures.push_back(std::move(texture));
    return static_cast<uint32_t>(scene.textures.size() - 1);
}

// Adds the material of the opaque part (mask) or of the tips (blend). Light is reflected into a wide range of
// directions across a strand and into a narrow one along it. The tangents of the ribbons run across.
uint32_t add_hair_material(Scene& scene, uint32_t texture, AlphaMode part) {
    Material material;
    material.name = part == AlphaMode::mask ? "hair" : "hair tips";
    material.metallic = 0;
    material.roughness = 0.36f;
    material.anisotropy = 0.85f;
    material.specular_color = {1, 0.85f, 0.7f};
    material.double_sided = true;
    material.alpha_mode = part;
    material.alpha_cutoff = kOpaqueAlpha;
    material.base_color_texture.texture = texture;
    material.base_color_texture.wrap_u = material.base_color_texture.wrap_v = Wrap::clamp_to_edge;
    return add_material(scene, std::move(material));
}

// Returns the path of the middle of a ribbon. It begins on the head, in the direction `root` from its middle,
// is combed away from the parting, and hangs down outside of the head.
std::vector<glm::vec3> hang_ribbon(const glm::vec3& root, float lift_m, float wave) {
    const float least = kHeadRadius + lift_m;
    glm::vec3 at = root * least;
    std::vector<glm::vec3> path{at};
    const glm::vec3 combed = glm::vec3(root.x * 1.6f, -0.5f, root.z * 0.9f - 0.35f);
    glm::vec3 direction = glm::normalize(combed - root * glm::dot(combed, root));
    for (uint32_t i = 1; i < kSteps; ++i) {
        direction = glm::normalize(direction + glm::vec3(0, -0.3f, 0));
        const float turn = wave * std::sin(1.1f * static_cast<float>(i) + 9 * wave);
        at += kStep_m * (direction + turn * glm::vec3(root.z, 0, -root.x));
        const float distance = glm::length(at);
        if (distance < least) at *= least / distance;
        path.push_back(at);
    }
    return path;
}

void add_ribbon(MeshBuilder& builder, const std::vector<glm::vec3>& path, float half_width_m) {
    constexpr uint32_t kColumns = 3;
    builder.add_grid(kColumns, kSteps, [&](uint32_t column, uint32_t row) {
        const uint32_t step = kSteps - 1 - row;  // The front is outside if the rows run upwards.
        const glm::vec3 along = path[std::min(step + 1, kSteps - 1)] - path[step > 0 ? step - 1 : 0];
        const glm::vec3 out = glm::normalize(path[step] + glm::vec3(0, 0.12f, 0));
        const glm::vec3 across = glm::normalize(glm::cross(out, along));
        const float side = static_cast<float>(column) - 1;
        const float bulge = (1 - side * side) * 0.4f;
        return GridPoint{path[step] + half_width_m * (side * across + bulge * out),
                         {0.5f + 0.5f * side, static_cast<float>(step) / (kSteps - 1)}};
    });
}

Mesh make_hair() {
    MeshBuilder builder;
    Random random(23);
    for (uint32_t i = 0; i < kRibbons; ++i) {
        // Points that are spread evenly over the upper part of a sphere. The face, at +z, stays free.
        const float up = 0.985f - 0.93f * (static_cast<float>(i) + 0.5f) / kRibbons;
        const float angle = 2.39996323f * static_cast<float>(i), ring = std::sqrt(1 - up * up);
        const glm::vec3 root(ring * std::sin(angle), up, ring * std::cos(angle));
        const float lift_m = random.range(0.006f, 0.045f), wave = random.range(-0.16f, 0.16f);
        const float half_width_m = random.range(0.011f, 0.02f);
        if (root.z > 0.25f && root.y < 0.72f) continue;
        add_ribbon(builder, hang_ribbon(root, lift_m, wave), half_width_m);
    }
    return builder.finish("hair");
}

}  // namespace

void add_hair_on_stand(Scene& scene, const glm::vec3& base) {
    MeshBuilder stand;
    stand.add_lathe({{0.2f, 0},
                     {0.2f, 0.03f},
                     {0.05f, 0.06f},
                     {0.035f, 0.2f},
                     {0.06f, 0.5f},
                     {0.14f, kHeadHeight - 0.26f}},
                    {.segments = 32});
    stand.add_sphere({0, kHeadHeight, 0}, kHeadRadius, 48, 24);
    place(scene, stand.finish("stand"), add_matt(scene, "linen", {0.62f, 0.55f, 0.46f}, 0.8f),
          glm::translate(glm::mat4(1), base));
    const uint32_t texture = add_strands_texture(scene);
    const glm::mat4 at_head = glm::translate(glm::mat4(1), base + glm::vec3(0, kHeadHeight, 0));
    const auto mesh = static_cast<uint32_t>(scene.meshes.size());
    place(scene, make_hair(), add_hair_material(scene, texture, AlphaMode::mask), at_head);
    scene.instances.push_back(
        {"hair tips", mesh, add_hair_material(scene, texture, AlphaMode::blend), at_head});
}

}  // namespace weft::scene
