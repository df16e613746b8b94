// Purpose: makes the atrium's metals and the glass of the lanterns and bulbs.
#include <algorithm>
#include <cmath>

#include "scene/builtin/builtin_atrium_materials.h"

namespace weft::scene::atrium {
namespace {

// Luminance of the brightest point of a lantern's panes and of the glass of a bulb. The lamp inside would
// give higher values. These lower values keep the colour of the glass in pictures of the night.
constexpr float kPane_cd_per_m2 = 45, kBulb_cd_per_m2 = 60;

Surface bronze(const NoiseBank& bank) {
    return make_surface(kTextureSize, 1, [&](uint32_t x, uint32_t y) {
        const NoiseAt n = noise_at(bank, x, y);
        const float patina = smooth_step(0.52f, 0.70f, n.coarse(1) + 0.4f * (n.medium(2) - 0.5f));
        Texel texel;
        texel.color_srgb = mix3(rgb(0xb98050), rgb(0xd9a066), n.medium(1));
        texel.color_srgb = mix3(texel.color_srgb, rgb(0x4f8a78), patina * 0.8f) * (0.9f + 0.2f * n.fine());
        texel.height_m = 0.0006f * n.medium(4) + 0.0006f * patina * n.fine();
        texel.roughness = 0.3f + 0.12f * n.medium(3) + 0.4f * patina;
        texel.metalness = 1 - 0.85f * patina;
        return texel;
    });
}

Surface gold(const NoiseBank& bank) {
    return make_surface(kSmallTextureSize, 1, [&](uint32_t x, uint32_t y) {
        const NoiseAt n = noise_at(bank, x, y, kSmallTextureSize);
        Texel texel;
        texel.color_srgb = rgb(0xf6cf7d) * (0.94f + 0.08f * n.medium());
        texel.height_m = 0.0005f * n.medium(1);
        texel.roughness = 0.24f + 0.12f * n.medium(2);
        texel.metalness = 1;
        return texel;
    });
}

// Makes the texture of brushed steel. The scratches run along u.
Surface brushed_steel(const NoiseBank& bank) {
    return make_surface(kTextureSize, 0.5f, [&](uint32_t x, uint32_t y) {
        const NoiseAt n = noise_at(bank, x, y);
        const float scratch = n.grain(1);
        Texel texel;
        texel.color_srgb = rgb(0xcfd2d4) * (0.9f + 0.14f * scratch);
        texel.height_m = 0.0002f * scratch;
        texel.roughness = 0.26f + 0.2f * scratch;
        texel.metalness = 1;
        return texel;
    });
}

Surface iron(const NoiseBank& bank) {
    return make_surface(kSmallTextureSize, 0.5f, [&](uint32_t x, uint32_t y) {
        const NoiseAt n = noise_at(bank, x, y, kSmallTextureSize);
        const float rust = smooth_step(0.58f, 0.75f, n.medium(2));
        Texel texel;
        texel.color_srgb = mix3(rgb(0x4b4a4c), rgb(0x6d3f26), rust) * (0.85f + 0.3f * n.fine());
        texel.height_m = 0.0015f * n.medium(1);
        texel.roughness = 0.48f + 0.3f * rust;
        texel.metalness = 1 - 0.8f * rust;
        return texel;
    });
}

// Makes the picture of a flame seen through old glass, brightest in the middle. Each pane of a lantern shows
// the picture once.
uint32_t glow_texture(Parts& parts) {
    constexpr uint32_t kPane = 64;
    std::vector<glm::vec3> glow(kPane * kPane);
    for (uint32_t y = 0; y < kPane; ++y) {
        for (uint32_t x = 0; x < kPane; ++x) {
            const glm::vec2 p = (glm::vec2(x, y) + 0.5f) / static_cast<float>(kPane) - glm::vec2(0.5f, 0.58f);
            const float flame = std::exp(-glm::dot(p, p) * 16);
            glow[y * kPane + x] = mix3(rgb(0xc96a1e), rgb(0xfff0c4), flame);
        }
    }
    return add_color_texture(parts.scene, "lantern_glow", kPane, glow);
}

Surface glass(const NoiseBank& bank) {
    return make_surface(kSmallTextureSize, 1, [&](uint32_t x, uint32_t y) {
        const NoiseAt n = noise_at(bank, x, y, kSmallTextureSize);
        Texel texel;
        texel.color_srgb = rgb(0x8a5a24);
        texel.height_m = 0.004f * n.medium(1);
        texel.roughness = 0.18f;
        return texel;
    });
}

Surface bulb(const NoiseBank& bank) {
    return make_surface(kSmallTextureSize, 1, [&](uint32_t x, uint32_t y) {
        Texel texel;
        texel.color_srgb = rgb(0xe9d9b8);
        texel.height_m = 0.0005f * noise_at(bank, x, y, kSmallTextureSize).medium(1);
        texel.roughness = 0.12f;
        return texel;
    });
}

}  // namespace

void make_metal_materials(Parts& parts) {
    Materials& m = parts.materials;
    const NoiseBank& bank = parts.noise;
    m.bronze = add_material(parts, "bronze", bronze(bank));
    m.gold = add_material(parts, "gold", gold(bank));
    m.steel = add_material(parts, "brushed_steel", brushed_steel(bank));
    m.iron = add_material(parts, "wrought_iron", iron(bank));
    m.glass = add_material(parts, "lantern_glass", glass(bank));
    Material& pane = parts.scene.materials[m.glass];
    pane.emissive = kPane_cd_per_m2 * glm::vec3(1, 0.82f, 0.62f);
    pane.emissive_texture.texture = glow_texture(parts);
    pane.emissive_texture.wrap_u = Wrap::clamp_to_edge;
    pane.emissive_texture.wrap_v = Wrap::clamp_to_edge;
    m.bulb = add_material(parts, "bulb_glass", bulb(bank));
    parts.scene.materials[m.bulb].emissive =
        parts.daylight.lamps * kBulb_cd_per_m2 * glm::vec3(1, 0.72f, 0.4f);
}

}  // namespace weft::scene::atrium
