// Purpose: turns the surfaces of the atrium's material files into materials.
#pragma once

#include <string>

#include "scene/builtin/builtin_atrium_parts.h"
#include "scene/procedural/procedural_patterns.h"
#include "scene/procedural/procedural_texture.h"

namespace weft::scene::atrium {

inline constexpr uint32_t kTextureSize = 512;

// Reads the noise bank, made for 512 texels, at a texel of a surface of `size` texels; the result still
// tiles.
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

// An opaque material; the surface's three textures repeat every `period_m`.
uint32_t add_material(Parts& parts, const std::string& name, const Surface& surface);
// The same for leaves: alpha-masked, double-sided, textures clamped because they cover one card.
uint32_t add_leaf_material(Parts& parts, const std::string& name, const Surface& surface);
// Fraction of the sky's light that reaches a surface, by height: `values` are spread evenly from `low_m` to
// `high_m`. For meshes whose v is the negated height.
void shade_by_height(Parts& parts, uint32_t material, const std::vector<float>& values, float low_m,
                     float high_m);

[[nodiscard]] inline glm::vec3 mix3(glm::vec3 a, glm::vec3 b, float t) {
    return a + (b - a) * t;
}

}  // namespace weft::scene::atrium
