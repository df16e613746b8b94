// Purpose: makes the atrium's marble floors, glazed tiles, and the water of the pool.
#include <algorithm>
#include <cmath>

#include "scene/builtin/builtin_atrium_materials.h"

namespace weft::scene::atrium {
namespace {

Surface checker_floor(const NoiseBank& bank) {
    return make_surface(kTextureSize, 2, [&](uint32_t x, uint32_t y) {
        const Block block = block_at({4, 4, 0}, x, y, kTextureSize, 2);
        const NoiseAt n = noise_at(bank, x + block.id % 400, y + block.id % 300);
        const NoiseAt here = noise_at(bank, x, y);
        const float vein = marble_vein(bank, x, y, block.id % 29);
        const bool dark = (block.column + block.row) & 1U;
        const float tone = hash_unit(block.id, 5, 5);
        glm::vec3 color = dark ? mix3(rgb(0x26322d), rgb(0x3f4f45), 0.3f * tone + 0.7f * n.medium())
                               : mix3(rgb(0xcdb894), rgb(0xe6d9bd), 0.4f * tone + 0.6f * n.medium());
        color = mix3(color, dark ? rgb(0x9fb0a2) : rgb(0x94795c), vein * (dark ? 0.45f : 0.5f));
        const float face = smooth_step(0.001f, 0.005f, block.edge_m);
        const float wear = smooth_step(0.45f, 0.7f, here.coarse(4));
        Texel texel;
        texel.color_srgb = mix3(rgb(0x5b5144), color, face);
        texel.height_m = 0.0022f * face + 0.0002f * here.medium(3) + 0.0008f * tone;
        texel.roughness = 0.13f + 0.14f * wear + 0.06f * here.fine() + 0.5f * (1 - face);
        return texel;
    });
}

// Makes the texture of a floor border: light diamonds on red between dark bands. v runs across the border.
Surface inlay_border(const NoiseBank& bank) {
    return make_surface(kSmallTextureSize, 0.5f, [&](uint32_t x, uint32_t y) {
        const NoiseAt n = noise_at(bank, x, y, kSmallTextureSize);
        const glm::vec2 p = (glm::vec2(x, y) + 0.5f) / static_cast<float>(kSmallTextureSize);
        const glm::vec2 center{p.x * 2 - std::floor(p.x * 2) - 0.5f, (p.y - 0.5f) * 2};
        const float big = diamond_distance(center, 0.44f);
        const float small = diamond_distance(center, 0.2f);
        const float fillet = std::abs(std::abs(p.y - 0.5f) - 0.36f);
        glm::vec3 color = rgb(0x9a5a34);
        if (big < 0) color = rgb(0xe0cfa9);
        if (small < 0) color = rgb(0x3d4a36);
        if (std::abs(p.y - 0.5f) > 0.36f) color = rgb(0x3a3a2c);
        if (fillet < 0.025f) color = rgb(0xd9b667);
        const float joint = std::min({std::abs(big), std::abs(small), std::abs(fillet - 0.025f)});
        const float face = smooth_step(0.002f, 0.012f, joint);
        Texel texel;
        texel.color_srgb = color * (0.85f + 0.28f * n.medium(1)) * (0.7f + 0.3f * face);
        texel.height_m = 0.0006f * face;
        texel.roughness = 0.45f + 0.15f * n.medium(2);
        return texel;
    });
}

glm::vec3 azulejo_color(glm::vec2 p) {
    const glm::vec3 white = rgb(0xe9e4d6);
    const glm::vec3 cobalt = rgb(0x1f4a8c);
    const float star = star_distance(p, 0.40f);
    const float inner = star_distance(p, 0.27f);
    const float core = glm::length(p) - 0.09f;
    const glm::vec2 corner = 0.5f - glm::abs(p);
    const float rosette = glm::length(corner) - 0.15f;
    const float corner_star = star_distance(corner, 0.24f);
    glm::vec3 color = white;
    if (corner_star < 0) color = rgb(0xc98b2e);
    if (corner_star < -0.03f) color = rgb(0x2f7a63);
    if (rosette < -0.07f) color = white;
    if (star < 0) color = cobalt;
    if (star < -0.035f) color = white;
    if (inner < 0) color = rgb(0x2a6cae);
    if (inner < -0.03f) color = rgb(0xd9a441);
    if (core < 0.035f) color = cobalt;
    if (core < 0) color = white;
    return color;
}

Surface azulejos(const NoiseBank& bank) {
    return make_surface(kTextureSize, 0.9f, [&](uint32_t x, uint32_t y) {
        const NoiseAt n = noise_at(bank, x, y);
        const Block block = block_at({3, 3, 0}, x, y, kTextureSize, 0.9f);
        const float face = smooth_step(0.001f, 0.004f, block.edge_m);
        glm::vec3 color = azulejo_color(block.local - 0.5f);
        color *= 0.88f + 0.1f * hash_unit(block.id, 6, 5) + 0.1f * n.medium(1);
        Texel texel;
        texel.color_srgb = mix3(rgb(0x8e8474), color, face);
        const glm::vec2 bow = block.local - 0.5f;
        texel.height_m = 0.003f * face - 0.002f * glm::dot(bow, bow) + 0.0005f * n.medium(2);
        texel.roughness = 0.16f + 0.1f * n.medium(3) + 0.5f * (1 - face);
        return texel;
    });
}

glm::vec3 zellige_color(uint32_t id) {
    const float pick = hash_unit(id, 7, 5);
    const glm::vec3 base = pick < 0.45f   ? rgb(0x1f7f86)
                           : pick < 0.75f ? rgb(0x2b9c96)
                           : pick < 0.9f  ? rgb(0x17586f)
                                          : rgb(0x6bbcae);
    return base * (0.8f + 0.4f * hash_unit(id, 8, 5));
}

Surface zellige(const NoiseBank& bank) {
    constexpr float kPeriod = 0.8f;
    return make_surface(kTextureSize, kPeriod, [&](uint32_t x, uint32_t y) {
        const NoiseAt n = noise_at(bank, x, y);
        const Block block = block_at({10, 10, 0}, x, y, kTextureSize, kPeriod);
        const float face = smooth_step(0.001f, 0.004f, block.edge_m);
        const glm::vec2 tilt = glm::vec2(hash_unit(block.id, 1, 3), hash_unit(block.id, 2, 3)) - 0.5f;
        Texel texel;
        texel.color_srgb = mix3(rgb(0xb9ae98), zellige_color(block.id) * (0.85f + 0.3f * n.fine()), face);
        texel.height_m = 0.002f * face + 0.003f * glm::dot(tilt, block.local) * face + 0.0003f * n.fine(1);
        texel.roughness = 0.14f + 0.1f * n.medium(3) + 0.5f * (1 - face);
        return texel;
    });
}

// Makes the ripples on the surface of the water. The surface itself has no colour.
Surface water(const NoiseBank& bank) {
    return make_surface(kTextureSize, 4, [&](uint32_t x, uint32_t y) {
        const NoiseAt n = noise_at(bank, x, y);
        Texel texel;
        texel.color_srgb = glm::vec3(1);
        texel.height_m = 0.008f * n.medium(4) + 0.02f * n.coarse(2);
        texel.roughness = 0.04f;
        return texel;
    });
}

}  // namespace

void make_tile_materials(Parts& parts) {
    Materials& m = parts.materials;
    const NoiseBank& bank = parts.noise;
    m.checker = add_material(parts, "checker_marble", checker_floor(bank));
    m.inlay = add_material(parts, "inlaid_border", inlay_border(bank));
    // A roof covers half of the sky above the border, so only half of the sky's light reaches the border.
    shade_by_height(parts, m.inlay, {0.5f, 0.5f}, 0, 1);
    m.azulejo = add_material(parts, "azulejo_tiles", azulejos(bank));

    shade_by_height(parts, m.azulejo, {0.25f, 0.38f, 0.42f, 0.42f}, kFloor, kFloor + 1.2f);
    m.zellige = add_material(parts, "zellige_tiles", zellige(bank));
    m.water = add_material(parts, "water", water(bank));
    Material& surface = parts.scene.materials[m.water];
    surface.ior = 1.33f;
    surface.alpha_mode = AlphaMode::blend;
    surface.transmission = 1;
    surface.thickness_m = kWaterDepth;
    // Of light along 1 m, 30 % of the red, 72 % of the green and 70 % of the blue pass.
    surface.absorption_per_m = -glm::log(glm::vec3(0.3f, 0.72f, 0.7f));
    surface.normal_scale = 0.6f;
    surface.ripples = {0.011f, 0.006f, -0.008f, 0.012f};
}

}  // namespace weft::scene::atrium
