// Purpose: how the atrium's material files turn a surface into a material.
#pragma once

#include <string>

#include "scene/builtin/builtin_atrium_parts.h"
#include "scene/procedural/procedural_patterns.h"
#include "scene/procedural/procedural_texture.h"

namespace weft::scene::atrium {

inline constexpr uint32_t kTextureSize = 512;

// Reads the bank, made for 512 texels, from a surface of `size` texels without breaking its repeat.
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

// An opaque material with the surface's three textures repeating at its period.
uint32_t add_material(Parts& parts, const std::string& name, const Surface& surface);
// The same for leaves: masked, double-sided, textures clamped to one card.
uint32_t add_leaf_material(Parts& parts, const std::string& name, const Surface& surface);
// How much of the sky's light a surface gets, by height: `values` from `low_m` up to `high_m`, for meshes
// whose v is the negated height.
void shade_by_height(Parts& parts, uint32_t material, const std::vector<float>& values, float low_m,
                     float high_m);

[[nodiscard]] inline glm::vec3 mix3(glm::vec3 a, glm::vec3 b, float t) {
    return a + (b - a) * t;
}

}  // namespace weft::scene::atrium
