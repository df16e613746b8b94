// Purpose: makes the atrium's materials of wood, clay and cloth.
#include <algorithm>
#include <cmath>

#include "scene/builtin/builtin_atrium_materials.h"

namespace weft::scene::atrium {
namespace {

struct WoodColors {
    glm::vec3 dark;
    glm::vec3 light;
    uint32_t boards;  // Number of boards across the texture. The wood grain runs along u.
    float gap_m;
};

Surface wood(const NoiseBank& bank, const WoodColors& wood_colors) {
    return make_surface(kTextureSize, 1, [&](uint32_t x, uint32_t y) {
        const Block board = block_at({1, wood_colors.boards, 0.37f}, x, y, kTextureSize, 1);
        const NoiseAt n = noise_at(bank, x + board.row * 173, y + board.row * 57);
        const float bend = n.coarse(2) * 3 + n.grain(1) * 1.4f;
        const float rings = 0.5f + 0.5f * std::sin(6.2831853f * (bend + board.local.y * 1.2f));
        const float fiber = n.grain(3);
        const float tone = hash_unit(board.id, 9, 5);
        glm::vec3 color =
            mix3(wood_colors.dark, wood_colors.light, 0.25f + 0.35f * rings + 0.5f * (fiber - 0.3f));
        color *= 0.82f + 0.3f * tone;
        const float gap = std::min(board.local.y, 1 - board.local.y) / static_cast<float>(wood_colors.boards);
        const float face =
            wood_colors.gap_m > 0 ? smooth_step(wood_colors.gap_m * 0.5f, wood_colors.gap_m, gap) : 1.0f;
        Texel texel;
        texel.color_srgb = color * (0.35f + 0.65f * face);
        texel.height_m = 0.004f * face + 0.0012f * fiber + 0.0005f * rings;
        texel.roughness = 0.62f + 0.2f * fiber;
        return texel;
    });
}

Surface clay(const NoiseBank& bank) {
    return make_surface(kTextureSize, 1, [&](uint32_t x, uint32_t y) {
        const NoiseAt n = noise_at(bank, x, y);
        const float bloom = smooth_step(0.5f, 0.72f, n.coarse(2) + 0.4f * (n.medium(1) - 0.5f));
        glm::vec3 color = mix3(rgb(0xa2502f), rgb(0xc57a50), n.medium(3));
        color = mix3(color, rgb(0xd9bfa4), bloom * 0.55f);
        color *= 0.9f + 0.2f * n.fine(2);
        Texel texel;
        texel.color_srgb = color;
        const float turning =
            std::sin(static_cast<float>(y) * 6.2831853f * 40 / static_cast<float>(kTextureSize));
        texel.height_m = 0.0006f * turning + 0.001f * n.medium(4) + 0.0006f * n.fine();
        texel.roughness = 0.88f - 0.1f * n.medium(5);
        return texel;
    });
}

// Makes the texture of the roof: tiles that are 0.25 m wide and 0.33 m long, each in its own tone.
Surface roof_tiles(const NoiseBank& bank) {
    return make_surface(kTextureSize, 2, [&](uint32_t x, uint32_t y) {
        const NoiseAt n = noise_at(bank, x, y);
        const Block tile = block_at({8, 6, 0}, x, y, kTextureSize, 2);
        const float tone = hash_unit(tile.id, 10, 5);
        glm::vec3 color = mix3(rgb(0x8f4a2e), rgb(0xc0734a), tone);
        color = mix3(color, rgb(0xb9a27e), smooth_step(0.58f, 0.74f, n.medium(1)) * 0.6f);
        color *= 0.8f + 0.3f * n.fine(1);
        const float lip = smooth_step(0.0f, 0.1f, tile.local.y);
        Texel texel;
        texel.color_srgb = color * (0.55f + 0.45f * lip);
        texel.height_m = 0.02f * (1 - tile.local.y) + 0.002f * n.fine();
        texel.roughness = 0.9f;
        return texel;
    });
}

struct ClothColors {
    glm::vec3 ground;
    glm::vec3 pattern;
    glm::vec3 border;
};

// Makes the texture of a patterned cloth. The thread of the pattern looks metallic only because it is bright:
// the material is a dielectric.
Surface cloth(const NoiseBank& bank, const ClothColors& colors) {
    constexpr float kPeriod = 1.2f;
    return make_surface(kTextureSize, kPeriod, [&](uint32_t x, uint32_t y) {
        const NoiseAt n = noise_at(bank, x, y);
        const glm::vec2 p = (glm::vec2(x, y) + 0.5f) / static_cast<float>(kTextureSize);
        const glm::vec2 c{p.x - 0.5f, p.y - 0.5f};
        const glm::vec2 half{p.x - 0.5f, p.y < 0.5f ? p.y : p.y - 1};
        const float edge = std::min(p.x, 1 - p.x);
        const float outline = std::abs(star_distance(c, 0.26f));
        const float diamond = std::abs(diamond_distance(half, 0.2f));
        bool figured = outline < 0.014f || star_distance(c, 0.15f) < 0 || diamond < 0.012f;
        figured = figured || diamond_distance(half, 0.09f) < 0;
        if (star_distance(c, 0.075f) < 0) figured = false;
        const bool border = (edge > 0.035f && edge < 0.095f) || (edge > 0.115f && edge < 0.13f);
        glm::vec3 color = figured ? colors.pattern : colors.ground;
        if (border) color = colors.border;
        const float threads = weave_height(x, y, kTextureSize, 128);
        color *= 0.78f + 0.2f * threads + 0.14f * n.medium(2) + 0.1f * (n.grain(1) - 0.5f);
        Texel texel;
        texel.color_srgb = color;
        texel.height_m = 0.0011f * threads + (figured || border ? 0.0008f : 0.0f) + 0.002f * n.medium(4);
        texel.roughness = figured || border ? 0.55f : 0.82f;
        return texel;
    });
}

}  // namespace

void make_craft_materials(Parts& parts) {
    Materials& m = parts.materials;
    const NoiseBank& bank = parts.noise;
    m.beam = add_material(parts, "dark_timber", wood(bank, {rgb(0x2f1d12), rgb(0x6e4a2c), 4, 0.004f}));
    shade_by_height(parts, m.beam, {0.4f, 0.4f}, 0, 1);
    m.planks = add_material(parts, "planks", wood(bank, {rgb(0x7a5532), rgb(0xbf965f), 6, 0.004f}));
    m.door = add_material(parts, "painted_boards", wood(bank, {rgb(0x1f4a4a), rgb(0x3f7f78), 6, 0.004f}));
    shade_by_height(parts, m.door, {0.5f, 0.5f}, 0, 1);
    m.clay = add_material(parts, "terracotta", clay(bank));
    m.roof = add_material(parts, "roof_tiles", roof_tiles(bank));
    m.cloth_red =
        add_material(parts, "cloth_red", cloth(bank, {rgb(0x98182a), rgb(0xd8a945), rgb(0xe0b45a)}));
    m.cloth_saffron =
        add_material(parts, "cloth_saffron", cloth(bank, {rgb(0xd98a1c), rgb(0x8e2a1e), rgb(0xf0d9a0)}));
    m.cloth_indigo =
        add_material(parts, "cloth_indigo", cloth(bank, {rgb(0x23397f), rgb(0xd9c48a), rgb(0xe3d5ab)}));
    for (const uint32_t index : {m.cloth_red, m.cloth_saffron, m.cloth_indigo}) {
        parts.scene.materials[index].double_sided = true;
    }
}

}  // namespace weft::scene::atrium
