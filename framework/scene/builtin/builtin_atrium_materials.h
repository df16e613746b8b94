// Purpose: functions that make materials from textures, used by all files that define the atrium's materials.
#pragma once

#include <string>

#include "scene/builtin/builtin_atrium_parts.h"
#include "scene/procedural/procedural_patterns.h"
#include "scene/procedural/procedural_texture.h"

namespace weft::scene::atrium {

inline constexpr uint32_t kTextureSize = 512;
inline constexpr uint32_t kSmallTextureSize = 256;

// Reads the shared noise, which has 512 × 512 values, for one texel of a texture. `offset` selects another
// part of the same noise. For a smaller texture, noise_at() skips values evenly, so the noise still repeats
// at the texture's edges.
struct NoiseAt {
    const NoiseBank& bank;
    uint32_t x;
    uint32_t y;
    [[nodiscard]] float coarse(uint32_t offset = 0) const {
        return bank.coarse.at(x + offset * 97, y + offset * 211);
    }
    [[nodiscard]] float medium(uint32_t offset = 0) const {
        return bank.medium.at(x + offset * 97, y + offset * 211);
    }
    [[nodiscard]] float fine(uint32_t offset = 0) const {
        return bank.fine.at(x + offset * 97, y + offset * 211);
    }
    [[nodiscard]] float grain(uint32_t offset = 0) const {
        return bank.grain.at(x + offset * 97, y + offset * 211);
    }
};
[[nodiscard]] inline NoiseAt noise_at(const NoiseBank& bank, uint32_t x, uint32_t y,
                                      uint32_t size = kTextureSize) {
    const uint32_t stride = kTextureSize / size;
    return {bank, x * stride, y * stride};
}

// Adds an opaque material and returns its index. The three textures of the material repeat every
// `surface.period_m` metres.
uint32_t add_material(Parts& parts, const std::string& name, const Surface& surface);
// Adds a material for leaves: alpha-masked and double-sided. Its textures are clamped to the edge, because
// they do not repeat: they cover a leaf card, a frond or a lily pad once. Returns the index of the material.
uint32_t add_leaf_material(Parts& parts, const std::string& name, const Surface& surface);
// Sets how much of the sky's light reaches a material's surface, as a function of height. `values` are
// fractions at heights spread evenly from `low_m` to `high_m`. The meshes must have v = -height.
void shade_by_height(Parts& parts, uint32_t material, const std::vector<float>& values, float low_m,
                     float high_m);

[[nodiscard]] inline glm::vec3 mix3(glm::vec3 a, glm::vec3 b, float t) {
    return a + (b - a) * t;
}

}  // namespace weft::scene::atrium
