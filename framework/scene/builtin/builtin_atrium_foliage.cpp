// Purpose: makes the atrium's materials of plants. Most leaf textures show several leaves and are drawn leaf
// by leaf.
#include <algorithm>
#include <cmath>

#include "scene/builtin/builtin_atrium_materials.h"
#include "scene/model/angles.h"

namespace weft::scene::atrium {
namespace {

glm::vec3 varied(Random& random, glm::vec3 a, glm::vec3 b) {
    const glm::vec3 hue = mix3(a, b, random.unit());
    return hue * random.range(0.85f, 1.1f);
}

// Draws a side twig: leaves on alternating sides of a stalk, and one leaf at its end.
void draw_twig(Surface& surface, Random& random, glm::vec2 from, float angle, float length) {
    const glm::vec2 along{std::cos(angle), std::sin(angle)};
    draw_stalk(surface, from, from + along * length, 5, rgb(0x5d5a2c));
    for (int i = 0; i < 8; ++i) {
        const float t = static_cast<float>(i) / 7;
        LeafStroke leaf;
        leaf.base = from + along * (length * (0.2f + 0.8f * t));
        leaf.angle = angle + (i == 7 ? 0.0f : (i & 1 ? 1.0f : -1.0f) * random.range(0.6f, 1.15f));
        leaf.length = random.range(82, 112);
        leaf.width = leaf.length * random.range(0.4f, 0.48f);
        leaf.color_srgb = varied(random, rgb(0x2f5a20), rgb(0x648f3a));
        leaf.depth_m = random.range(0, 0.01f);
        draw_leaf(surface, leaf);
    }
}

// Makes the texture of a branch of glossy leaves. The branch starts at the middle of the lower edge.
Surface citrus_twig() {
    Random random(101);
    Surface surface = blank_leaf_surface(kTextureSize, 0.5f, rgb(0x3f6a2a));
    draw_stalk(surface, {256, 500}, {256, 150}, 8, rgb(0x5d5a2c));
    for (int i = 0; i < 6; ++i) {
        const float side = i & 1 ? 1.0f : -1.0f;
        const float t = static_cast<float>(i) / 5;
        draw_twig(surface, random, {256, 430 - 250 * t}, -0.5f * kPi + side * (1.05f - 0.35f * t),
                  125 - 25 * t);
    }
    draw_twig(surface, random, {256, 200}, -0.5f * kPi, 95);
    return surface;
}

// Makes the texture of a vine that winds upwards, with leaves on both sides.
Surface ivy_sprig() {
    Random random(202);
    Surface surface = blank_leaf_surface(kTextureSize, 0.5f, rgb(0x35592a));
    glm::vec2 before{240, 505};
    for (int i = 0; i < 16; ++i) {
        const float t = static_cast<float>(i) / 15;
        const glm::vec2 node{256 + 70 * std::sin(4.5f * t + 0.4f), 470 - 400 * t};
        draw_stalk(surface, before, node, 6, rgb(0x5a4a2a));
        before = node;
        LeafStroke leaf;
        leaf.length = random.range(95, 140) * (1 - 0.25f * t);
        leaf.width = leaf.length * 1.05f;
        leaf.angle = kPi / 2 + random.range(-0.9f, 0.9f);
        const float side = (i & 1 ? 1.0f : -1.0f) * random.range(35, 105);
        const glm::vec2 middle = node + glm::vec2(side, random.range(-25, 25));
        leaf.base = middle - glm::vec2(std::cos(leaf.angle), std::sin(leaf.angle)) * (leaf.length * 0.35f);
        leaf.color_srgb = varied(random, rgb(0x274a20), rgb(0x5d8440));
        leaf.depth_m = 0.001f * static_cast<float>(i);
        draw_stalk(surface, node, leaf.base, 4, rgb(0x5a4a2a));
        draw_leaf(surface, leaf);
    }
    return surface;
}

// Makes the texture of one fern frond: small leaves on both sides of a rib that runs upwards.
Surface fern_frond() {
    Random random(303);
    Surface surface = blank_leaf_surface(kTextureSize, 0.7f, rgb(0x4a7a30));
    draw_stalk(surface, {256, 511}, {256, 20}, 9, rgb(0x6f7a3a));
    for (int i = 0; i < 44; ++i) {
        const float t = static_cast<float>(i / 2) / 21;
        const float side = i & 1 ? 1.0f : -1.0f;
        LeafStroke leaf;
        leaf.base = {256, 490 - 450 * t};
        leaf.angle = -kPi / 2 + side * (1.15f - 0.65f * t) + random.range(-0.06f, 0.06f);
        leaf.length = 235 * std::pow(std::sin(kPi * (0.16f + 0.80f * t)), 0.7f) * random.range(0.92f, 1.05f);
        leaf.width = 17;
        leaf.shape = LeafShape::needle;
        leaf.color_srgb = varied(random, rgb(0x3c6d26), rgb(0x76a044));
        leaf.depth_m = 0.0003f * static_cast<float>(i);
        draw_leaf(surface, leaf);
    }
    return surface;
}

// Makes the texture of bougainvillea: bracts (pink leaves) in groups of three above a few green leaves.
Surface blossom_sprig() {
    Random random(404);
    Surface surface = blank_leaf_surface(kTextureSize, 0.5f, rgb(0x9c2f6a));
    for (int i = 0; i < 7; ++i) {
        LeafStroke leaf;
        leaf.base = {random.range(150, 360), random.range(150, 360)};
        leaf.angle = random.range(0, 2 * kPi);
        leaf.length = random.range(130, 170);
        leaf.width = leaf.length * 0.5f;
        leaf.color_srgb = varied(random, rgb(0x315a26), rgb(0x5a8238));
        draw_leaf(surface, leaf);
    }
    for (int i = 0; i < 14; ++i) {
        const float turn = static_cast<float>(i) * 2.39996f;
        const glm::vec2 middle = glm::vec2(256) + glm::vec2(std::cos(turn), std::sin(turn)) *
                                                      (48 * std::sqrt(static_cast<float>(i)));
        const float start = random.range(0, 2 * kPi);
        const glm::vec3 color = varied(random, rgb(0xb01f6e), rgb(0xe0569a));
        for (int k = 0; k < 3; ++k) {
            LeafStroke bract;
            bract.base = middle;
            bract.angle = start + static_cast<float>(k) * 2 * kPi / 3;
            bract.length = random.range(52, 68);
            bract.width = bract.length * 0.85f;
            bract.color_srgb = color * random.range(0.9f, 1.1f);
            bract.depth_m = 0.004f + 0.0006f * static_cast<float>(i);
            draw_leaf(surface, bract);
        }
        draw_leaf(surface, {middle - glm::vec2(6, 0), 0, 12, 12, LeafShape::round, rgb(0xf4ecc8), 0.02f});
    }
    return surface;
}

// Makes the texture of a cypress: dense, upright shoots with scale-like leaves.
Surface cypress_spray() {
    Random random(505);
    Surface surface = blank_leaf_surface(kTextureSize, 0.8f, rgb(0x2a4426));
    for (int i = 0; i < 230; ++i) {
        LeafStroke shoot;
        const float first = random.unit();
        const float second = random.unit();
        shoot.base = {256 + 190 * (first + second - 1), random.range(120, 505)};
        shoot.angle = -kPi / 2 + (shoot.base.x - 256) * 0.0035f + random.range(-0.5f, 0.5f);
        shoot.length = random.range(50, 100);
        shoot.width = random.range(8, 13);
        shoot.shape = LeafShape::needle;
        shoot.color_srgb = varied(random, rgb(0x203c20), rgb(0x4a6a38));
        shoot.depth_m = 0.0001f * static_cast<float>(i);
        draw_leaf(surface, shoot);
    }
    return surface;
}

// Makes the texture of a water lily: one round floating leaf with a notch.
Surface lily_pad() {
    constexpr uint32_t kSize = 256;
    Random random(606);
    Surface surface = blank_leaf_surface(kSize, 0.4f, rgb(0x4b7a3a));
    for (uint32_t y = 0; y < kSize; ++y) {
        for (uint32_t x = 0; x < kSize; ++x) {
            const glm::vec2 p = glm::vec2(x, y) - 127.5f;
            const float radius = glm::length(p);
            const float angle = std::atan2(p.y, p.x);
            const float notch = (std::abs(angle) - 0.2f) * radius - 2;
            const float inside = std::min(117 - radius, radius > 12 ? notch : 117 - radius);
            Texel& texel = surface.at(x, y);
            texel.alpha = std::clamp(0.5f + inside * 0.5f, 0.0f, 1.0f);
            const float rays = std::abs(std::sin(angle * 9));
            const float rim = smooth_step(96, 116, radius);
            texel.color_srgb = mix3(rgb(0x4d8038), rgb(0x86b052), 0.3f + 0.4f * std::pow(1 - rays, 4.0f));
            texel.color_srgb = mix3(texel.color_srgb, rgb(0x7a5a3a), rim * 0.6f);
            texel.height_m = 0.002f * rays + 0.006f * rim;
            texel.roughness = 0.65f;
        }
    }
    return surface;
}

Surface bark(const NoiseBank& bank) {
    return make_surface(kSmallTextureSize, 0.5f, [&](uint32_t x, uint32_t y) {
        // x and y are swapped, because the noise is stretched along x and the grain shall run up the trunk.
        const NoiseAt n = noise_at(bank, y, x, kSmallTextureSize);
        const float ridge = n.grain(2);
        Texel texel;
        texel.color_srgb = mix3(rgb(0x4a3826), rgb(0x8d7a60), ridge) * (0.8f + 0.4f * n.medium(1));
        texel.height_m = 0.008f * ridge;
        texel.roughness = 0.92f;
        return texel;
    });
}

Surface orange_peel(const NoiseBank& bank) {
    return make_surface(kSmallTextureSize, 0.25f, [&](uint32_t x, uint32_t y) {
        const NoiseAt n = noise_at(bank, x, y, kSmallTextureSize);
        Texel texel;
        texel.color_srgb = mix3(rgb(0xd9701a), rgb(0xf0982c), n.medium(1)) * (0.92f + 0.16f * n.fine());
        texel.height_m = 0.0012f * n.fine(1);
        texel.roughness = 0.42f;
        return texel;
    });
}

}  // namespace

void make_foliage_materials(Parts& parts) {
    Materials& m = parts.materials;
    m.citrus = add_leaf_material(parts, "citrus_leaves", citrus_twig());
    m.ivy = add_leaf_material(parts, "ivy_leaves", ivy_sprig());
    m.fern = add_leaf_material(parts, "fern_fronds", fern_frond());
    m.blossom = add_leaf_material(parts, "bougainvillea", blossom_sprig());
    m.cypress = add_leaf_material(parts, "cypress_sprays", cypress_spray());
    m.lily = add_leaf_material(parts, "lily_pads", lily_pad());
    m.orange = add_material(parts, "orange_peel", orange_peel(parts.noise));
    m.bark = add_material(parts, "bark", bark(parts.noise));
}

}  // namespace weft::scene::atrium
