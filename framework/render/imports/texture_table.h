// Purpose: the order of the textures in the import "textures", a table that shaders index. Each entry is a
// texture of the scene together with a sampler, so a texture with two samplers has two entries. The members
// `*_texture` of shared::Material are indices in this table.
#pragma once

#include <array>
#include <cstdint>
#include <tuple>
#include <vector>

#include "shared/material.glsl"
#include "weft/scene/scene.h"

namespace weft::render {

// The first two entries of the table have one texel each. Materials without a texture use them.
inline constexpr uint32_t kWhiteEntry = 0;
inline constexpr uint32_t kFlatNormalEntry = 1;

// The properties of a texture slot that determine its sampler.
using SamplerKey = std::tuple<scene::Filter, scene::Filter, bool, scene::Wrap, scene::Wrap>;
[[nodiscard]] SamplerKey sampler_key(const scene::TextureSlot& slot);

struct TextureTable {
    // The slot that made each entry. The first two entries have slots without a texture.
    std::vector<scene::TextureSlot> entries;
    // For each material: the indices of the base colour, metallic-roughness, normal, occlusion, emissive and
    // anisotropy texture.
    std::vector<std::array<uint32_t, 6>> materials;
};
[[nodiscard]] TextureTable texture_table(const scene::Scene& scene);

// Sets the texture indices of `to`.
void set_textures(const std::array<uint32_t, 6>& indices, shared::Material& to);

}  // namespace weft::render
