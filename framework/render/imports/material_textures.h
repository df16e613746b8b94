// Purpose: the order of the textures in the import "materialTextures", a table that shaders index. The
// members `*_texture` of shared::Material are indices in this table.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "shared/material.glsl"
#include "weft/scene/scene.h"

namespace weft::render {

inline constexpr const char* kMaterialTextures = "materialTextures";
// The first two textures of the table have one texel each. Materials without a texture use them.
inline constexpr uint32_t kWhiteEntry = 0;
inline constexpr uint32_t kFlatNormalEntry = 1;
inline constexpr uint32_t kFirstTexture = 2;

struct MaterialTextures {
    // Indices into Scene::textures, in the order of the first use by a material. The texture of textures[i]
    // is number kFirstTexture + i of the table.
    std::vector<uint32_t> textures;
    // For each material: the numbers of its base colour, metallic-roughness, normal, occlusion, emissive and
    // anisotropy texture.
    std::vector<std::array<uint32_t, 6>> materials;

    [[nodiscard]] uint32_t count() const { return kFirstTexture + static_cast<uint32_t>(textures.size()); }
};
[[nodiscard]] MaterialTextures order_textures(const scene::Scene& scene);

// Returns all materials of the scene as shaders read them, with the numbers of their textures.
[[nodiscard]] std::vector<shared::Material> gpu_materials(const scene::Scene& scene);
// Returns all materials of a scene for a table without the scene's textures. All numbers of textures are
// those of the first two textures of the table.
[[nodiscard]] std::vector<shared::Material> gpu_materials_without_table(const scene::Scene& scene);

}  // namespace weft::render
