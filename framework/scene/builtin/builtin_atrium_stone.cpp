// Purpose: makes the atrium's materials of stone and plaster.
#include <algorithm>
#include <cmath>

#include "scene/builtin/builtin_atrium_materials.h"

namespace weft::scene::atrium {
namespace {

Surface ashlar(const NoiseBank& bank) {
    return make_surface(kTextureSize, 2, [&](uint32_t x, uint32_t y) {
        const NoiseAt n = noise_at(bank, x, y);
        const Block block = block_at({3, 6, 0.5f}, x, y, kTextureSize, 2);
        const float wobble = (n.medium(1) - 0.5f) * 0.008f;
        const float face = smooth_step(0.004f, 0.014f, block.edge_m + wobble);
        const float tone = hash_unit(block.id, 1, 5);
        const float warm = hash_unit(block.id, 2, 5);
        glm::vec3 color = mix3(rgb(0xcbb693), rgb(0xe2d3b4), tone);
        color = mix3(color, rgb(0xd3a982), warm * warm * 0.45f);
        color *= 0.86f + 0.22f * n.medium(2) + 0.10f * (n.fine() - 0.5f);
        const float pit = smooth_step(0.68f, 0.76f, n.fine(3));
        color *= 1 - 0.18f * pit;
        Texel texel;
        texel.color_srgb = mix3(rgb(0x9c8a70), color, face);
        texel.height_m = 0.008f * face + 0.004f * n.medium(4) * face + 0.0012f * n.fine() - 0.002f * pit;
        texel.roughness = 0.86f - 0.06f * tone;
        return texel;
    });
}

// Returns the texel of a cut stone surface at a point that lies `joint_m` metres from the nearest joint.
Texel dressed_stone(const NoiseAt& n, float joint_m) {
    const float bed = n.grain(2);
    const float face = smooth_step(0.002f, 0.007f, joint_m);
    glm::vec3 color = mix3(rgb(0xcbb997), rgb(0xe3d5b8), n.coarse(1));
    color *= 0.9f + 0.16f * n.medium() + 0.08f * (bed - 0.5f);
    const float pit = smooth_step(0.68f, 0.76f, n.fine(1)) * smooth_step(0.5f, 0.65f, n.medium(3));
    color *= 1 - 0.12f * pit;
    Texel texel;
    texel.color_srgb = mix3(rgb(0x8a7a60), color, 0.25f + 0.75f * face);
    texel.height_m = 0.0018f * n.medium(5) + 0.0007f * n.fine() - 0.001f * pit + 0.004f * face;
    texel.roughness = 0.62f + 0.16f * n.medium(2) + 0.1f * pit;
    return texel;
}

Surface trim_stone(const NoiseBank& bank) {
    return make_surface(kTextureSize, 1.5f,
                        [&](uint32_t x, uint32_t y) { return dressed_stone(noise_at(bank, x, y), 1); });
}

// Makes the texture of long stones in a row along u. The stones differ in brightness.
Surface coping_stone(const NoiseBank& bank) {
    return make_surface(kTextureSize, 1.5f, [&](uint32_t x, uint32_t y) {
        const Block block = block_at({2, 1, 0}, x, y, kTextureSize, 1.5f);
        const float joint_m = std::min(block.local.x, 1 - block.local.x) * 0.75f;
        Texel texel = dressed_stone(noise_at(bank, x + 211 * block.column, y), joint_m);
        texel.color_srgb *= block.column == 0 ? glm::vec3(1) : glm::vec3(0.95f, 0.93f, 0.9f);
        return texel;
    });
}

// Makes the texture of floor slabs, from the same limestone as the building's trim.
Surface slab_stone(const NoiseBank& bank) {
    return make_surface(kTextureSize, 2, [&](uint32_t x, uint32_t y) {
        const Block block = block_at({2, 2, 0.5f}, x, y, kTextureSize, 2);
        Texel texel = dressed_stone(noise_at(bank, x + block.id % 391, y + block.id % 277), block.edge_m);
        texel.color_srgb *= 0.9f + 0.1f * hash_unit(block.id, 12, 5);
        texel.roughness *= 0.7f;  // Footsteps have made the floor smoother than the same stone in a wall.
        return texel;
    });
}

// Makes the texture of the stones of an arch: cream and rose wedges in turn. u runs around the arch, and the
// texture has four wedges.
Surface voussoirs(const NoiseBank& bank) {
    constexpr float kPeriod = 1.1f;
    return make_surface(kTextureSize, kPeriod, [&](uint32_t x, uint32_t y) {
        const NoiseAt n = noise_at(bank, x, y);
        const float u = (static_cast<float>(x) + 0.5f) * 4 / static_cast<float>(kTextureSize);
        const auto index = static_cast<uint32_t>(u);
        const float local = u - static_cast<float>(index);
        const float edge_m = std::min(local, 1 - local) * kPeriod / 4;
        const float face = smooth_step(0.002f, 0.008f, edge_m + (n.medium(6) - 0.5f) * 0.004f);
        const glm::vec3 cream = mix3(rgb(0xe3d4b4), rgb(0xd6c09a), hash_unit(index, 0, 9));
        const glm::vec3 rose = mix3(rgb(0xb06a4c), rgb(0x9c5640), hash_unit(index, 0, 9));
        glm::vec3 color = index & 1U ? rose : cream;
        color *= 0.84f + 0.26f * n.medium(2) + 0.12f * (n.fine() - 0.5f);
        Texel texel;
        texel.color_srgb = mix3(rgb(0x8d7a62), color, face);
        texel.height_m = 0.006f * face + 0.003f * n.medium(4) + 0.0008f * n.fine();
        texel.roughness = 0.8f;
        return texel;
    });
}

Surface column_marble(const NoiseBank& bank) {
    return make_surface(kTextureSize, 1, [&](uint32_t x, uint32_t y) {
        const NoiseAt n = noise_at(bank, x, y);
        const float vein = marble_vein(bank, x, y, 3);
        glm::vec3 color = mix3(rgb(0xcbb6a4), rgb(0xe2d6c6), n.coarse(2));
        color = mix3(color, rgb(0xcdb09c), smooth_step(0.45f, 0.75f, n.medium(7)) * 0.4f);
        color = mix3(color, rgb(0x94786a), vein * 0.5f);
        color *= 0.96f + 0.08f * n.fine();
        Texel texel;
        texel.color_srgb = color;
        texel.height_m = 0.0004f * n.medium() - 0.0003f * vein;
        texel.roughness = 0.2f + 0.14f * n.medium(4) + 0.1f * vein;
        return texel;
    });
}

// Makes the texture of the court's floor: worn slabs with moss in the joints.
Surface court_flags(const NoiseBank& bank) {
    constexpr float kPeriod = 2.4f;
    return make_surface(kTextureSize, kPeriod, [&](uint32_t x, uint32_t y) {
        const NoiseAt n = noise_at(bank, x, y);
        const Block block = block_at({3, 4, 0.37f}, x, y, kTextureSize, kPeriod);
        const float edge = block.edge_m + (n.medium(1) - 0.5f) * 0.012f;
        const float face = smooth_step(0.006f, 0.018f, edge);
        const float tone = hash_unit(block.id, 3, 5);
        glm::vec3 color = mix3(rgb(0xb5a68c), rgb(0xd2c5aa), tone);
        color = mix3(color, rgb(0xb9977a), hash_unit(block.id, 4, 5) * 0.35f);
        color *= 0.82f + 0.28f * n.medium(block.id & 7U) + 0.14f * (n.fine() - 0.5f);
        const float worn = smooth_step(0.60f, 0.75f, n.coarse(3));
        color *= 1 - 0.12f * worn;
        const float moss = smooth_step(0.42f, 0.62f, n.coarse(5) + 0.3f * (n.fine(2) - 0.5f));
        const glm::vec3 joint = mix3(rgb(0x80725a), rgb(0x5d6a36), moss);
        Texel texel;
        texel.color_srgb = mix3(joint * (0.8f + 0.4f * n.fine(5)), color, face);
        texel.height_m = 0.009f * face + 0.006f * n.medium(block.id & 7U) * face + 0.0015f * n.fine();
        texel.roughness = 0.9f - 0.22f * face * (1 - n.medium(3));
        return texel;
    });
}

Surface plaster(const NoiseBank& bank, glm::vec3 color_srgb, glm::vec3 faded_srgb) {
    return make_surface(kTextureSize, 2.5f, [&](uint32_t x, uint32_t y) {
        const NoiseAt n = noise_at(bank, x, y);
        const float fade = smooth_step(0.40f, 0.68f, n.coarse(1) + 0.25f * (n.medium(2) - 0.5f));
        glm::vec3 color = mix3(color_srgb, faded_srgb, fade * 0.75f);
        color *= 0.86f + 0.24f * n.medium(3) + 0.06f * (n.fine() - 0.5f);
        const float crack = 1 - smooth_step(0.0f, 0.006f, std::abs(n.coarse(6) - 0.52f));
        color *= 1 - 0.12f * crack * n.medium(5);
        Texel texel;
        texel.color_srgb = color;
        texel.height_m = 0.006f * n.medium(4) + 0.0008f * n.grain(1) + 0.0008f * n.fine(2);
        texel.roughness = 0.82f + 0.1f * n.medium(6);
        return texel;
    });
}

Surface soil(const NoiseBank& bank) {
    return make_surface(kSmallTextureSize, 0.5f, [&](uint32_t x, uint32_t y) {
        const NoiseAt n = noise_at(bank, x, y, kSmallTextureSize);
        Texel texel;
        texel.color_srgb = mix3(rgb(0x2e2118), rgb(0x5b432e), smooth_step(0.3f, 0.7f, n.fine()));
        texel.color_srgb *= 0.8f + 0.4f * n.medium();
        texel.height_m = 0.012f * n.fine() + 0.015f * n.medium();
        texel.roughness = 0.95f;
        return texel;
    });
}

uint32_t copy_material(Parts& parts, uint32_t original, const char* name) {
    parts.scene.materials.push_back(parts.scene.materials[original]);
    parts.scene.materials.back().name = name;
    return static_cast<uint32_t>(parts.scene.materials.size() - 1);
}

}  // namespace

void make_stone_materials(Parts& parts) {
    Materials& m = parts.materials;
    const NoiseBank& bank = parts.noise;
    m.ashlar = add_material(parts, "limestone_ashlar", ashlar(bank));
    shade_by_height(parts, m.ashlar, {0.7f, 0.9f, 1, 1, 1, 1, 1, 0.95f, 0.5f}, 0, kWallTop);
    m.trim = add_material(parts, "limestone_trim", trim_stone(bank));
    // Limestone for surfaces that face the walkway and so see little of the sky. It is a copy of the trim's
    // material with a darker occlusion.
    m.trim_shaded = copy_material(parts, m.trim, "limestone_trim_shaded");
    shade_by_height(parts, m.trim_shaded, {0.42f, 0.42f}, 0, 1);
    m.trim_floor = add_material(parts, "limestone_slabs", slab_stone(bank));
    m.coping = add_material(parts, "limestone_coping", coping_stone(bank));
    m.voussoir = add_material(parts, "voussoirs", voussoirs(bank));
    m.marble = add_material(parts, "column_marble", column_marble(bank));
    shade_by_height(parts, m.marble, {0.55f, 0.8f, 0.85f, 0.85f, 0.8f, 0.6f}, 0, 2.4f);
    m.flags = add_material(parts, "court_flags", court_flags(bank));
    m.plaster_red = add_material(parts, "plaster_red", plaster(bank, rgb(0x814534), rgb(0xa8765a)));
    shade_by_height(parts, m.plaster_red, {0.42f, 0.45f, 0.42f, 0.36f, 0.26f, 0.14f}, kFloor + 1.4f,
                    kCeiling);
    m.plaster_ochre = add_material(parts, "plaster_ochre", plaster(bank, rgb(0xd8aa6c), rgb(0xe2bf8c)));
    shade_by_height(parts, m.plaster_ochre, {0.85f, 0.85f, 0.85f, 0.75f, 0.4f}, kUpperFloor, 7.9f);
    m.soil = add_material(parts, "soil", soil(bank));
}

}  // namespace weft::scene::atrium
