#include "scene/procedural/procedural_patterns.h"

#include <algorithm>
#include <cmath>

namespace weft::scene {
namespace {

// Returns half the width of a leaf as a fraction of its full width. `t` is the position along the midrib: 0
// at the stalk, 1 at the tip.
float leaf_half_width(LeafShape shape, float t) {
    if (t <= 0 || t >= 1) return 0;
    const float bulge = std::sin(3.14159265f * std::pow(t, 0.75f));
    switch (shape) {
        case LeafShape::pointed:
            return 0.5f * std::pow(bulge, 0.9f) * (1 - 0.25f * t);
        case LeafShape::round:
            return 0.5f * std::sqrt(std::max(0.0f, 1 - (2 * t - 1) * (2 * t - 1)));
        case LeafShape::needle:
            return 0.5f * std::pow(bulge, 0.5f);
        case LeafShape::ivy:
            break;
    }
    return 0;
}

// Outline of an ivy leaf: five lobes around a point near the stalk. The result is positive inside the leaf.
// `along` and `across` are fractions of the leaf's length and width; `across` is 0 on the midrib. They may be
// outside 0..1 and -0.5..0.5, because the lobes are larger than the nominal size.
float ivy_inside(float along, float across) {
    const glm::vec2 p{along - 0.32f, across};
    const float angle = std::atan2(p.y, p.x);
    const float lobes = std::abs(std::cos(angle * 1.25f));
    const float reach = 0.25f + 0.42f * std::pow(lobes, 1.6f) * (0.72f + 0.28f * std::cos(angle));
    return reach - glm::length(p);
}

struct LeafSample {
    float inside = -1;  // Distance to the edge of the leaf in texels; positive inside the leaf.
    // Strength of the midrib or a side vein at the sample: 1 in the middle of the midrib, 0 between the
    // veins.
    float rib = 0;
};

LeafSample sample_leaf(const LeafStroke& leaf, float along_px, float across_px) {
    const float t = along_px / leaf.length;
    LeafSample sample;
    if (leaf.shape == LeafShape::ivy) {
        sample.inside = ivy_inside(t, across_px / leaf.width) * leaf.length;
    } else {
        sample.inside = leaf_half_width(leaf.shape, t) * leaf.width - std::abs(across_px);
    }
    const float rib_px = std::max(0.8f, leaf.width * 0.025f);
    const float midrib = 1 - smooth_step(rib_px * 0.5f, rib_px * 1.6f, std::abs(across_px));
    const float slant = (along_px - std::abs(across_px) * 0.9f) / (leaf.length * 0.14f);
    const float vein = 1 - smooth_step(0.03f, 0.12f, std::abs(slant - std::round(slant)));
    sample.rib = std::max(midrib, leaf.shape == LeafShape::needle ? 0.0f : vein * 0.45f);
    return sample;
}

}  // namespace

Block block_at(const BlockLayout& layout, uint32_t x, uint32_t y, uint32_t size, float period_m) {
    const float inverse = 1 / static_cast<float>(size);
    const float v = (static_cast<float>(y) + 0.5f) * inverse * static_cast<float>(layout.rows);
    const auto row = static_cast<uint32_t>(v);
    const float columns = static_cast<float>(layout.columns);
    const float shifted =
        (static_cast<float>(x) + 0.5f) * inverse * columns + layout.shift * static_cast<float>(row);
    const float whole = std::floor(shifted);
    Block block;
    block.row = row;
    block.column = static_cast<uint32_t>(whole) % layout.columns;
    block.local = {shifted - whole, v - static_cast<float>(row)};
    block.id = hash_u32(block.column + 131 * row + 7);
    const glm::vec2 side = glm::vec2(period_m / columns, period_m / static_cast<float>(layout.rows));
    const glm::vec2 edge = glm::min(block.local, 1.0f - block.local) * side;
    block.edge_m = std::min(edge.x, edge.y);
    return block;
}

float marble_vein(const NoiseBank& bank, uint32_t x, uint32_t y, uint32_t offset) {
    const uint32_t ox = x + offset * 149;
    const uint32_t oy = y + offset * 311;
    const auto warp = static_cast<uint32_t>(bank.medium.at(ox, oy) * 70.0f);
    const float ridge = std::abs(bank.coarse.at(ox + warp, oy + 2 * warp) - 0.5f);
    const float thin = std::abs(bank.medium.at(oy + warp, ox) - 0.47f);
    return std::max(1 - smooth_step(0.0f, 0.035f, ridge), 0.5f * (1 - smooth_step(0.0f, 0.03f, thin)));
}

float weave_height(uint32_t x, uint32_t y, uint32_t size, uint32_t threads) {
    const float scale = static_cast<float>(threads) / static_cast<float>(size);
    const float u = (static_cast<float>(x) + 0.5f) * scale;
    const float v = (static_cast<float>(y) + 0.5f) * scale;
    const auto cell = static_cast<uint32_t>(u) + static_cast<uint32_t>(v);
    const float across = cell & 1U ? u - std::floor(u) : v - std::floor(v);
    const float along = cell & 1U ? v - std::floor(v) : u - std::floor(u);
    return std::sin(3.14159265f * across) * (0.6f + 0.4f * std::sin(3.14159265f * along));
}

float star_distance(glm::vec2 p, float radius) {
    const glm::vec2 a = glm::abs(p);
    const float square = std::max(a.x, a.y) - radius * 0.7071f;
    const float turned = (a.x + a.y) * 0.7071f - radius * 0.7071f;
    return std::min(square, turned);
}

float diamond_distance(glm::vec2 p, float radius) {
    return (std::abs(p.x) + std::abs(p.y) - radius) * 0.7071f;
}

void draw_leaf(Surface& surface, const LeafStroke& leaf) {
    const glm::vec2 along{std::cos(leaf.angle), std::sin(leaf.angle)};
    const glm::vec2 across{-along.y, along.x};
    // The lobes of an ivy leaf extend behind the joint with the stalk and beyond the nominal width, so a
    // larger area is searched for texels of the leaf.
    const float spill = leaf.shape == LeafShape::ivy ? 0.45f : 0.05f;
    const glm::vec2 middle = leaf.base + along * (leaf.length * 0.5f);
    const glm::vec2 half{leaf.length * (0.5f + spill) + 1, leaf.width * (0.5f + spill) + 1};
    const glm::vec2 extent = glm::abs(along) * half.x + glm::abs(across) * half.y;
    const float last = static_cast<float>(surface.size_px - 1);
    const glm::vec2 low = glm::clamp(middle - extent, glm::vec2(0), glm::vec2(last));
    const glm::vec2 high = glm::clamp(middle + extent, glm::vec2(0), glm::vec2(last));
    for (auto y = static_cast<uint32_t>(low.y); y <= static_cast<uint32_t>(high.y); ++y) {
        for (auto x = static_cast<uint32_t>(low.x); x <= static_cast<uint32_t>(high.x); ++x) {
            const glm::vec2 p = glm::vec2(x, y) - leaf.base;
            const float s = glm::dot(p, across);
            if (std::abs(s) > half.y) continue;
            const LeafSample sample = sample_leaf(leaf, glm::dot(p, along), s);
            if (sample.inside < -1) continue;
            Texel& texel = surface.at(x, y);
            texel.alpha = std::max(texel.alpha, std::clamp(0.5f + sample.inside * 0.5f, 0.0f, 1.0f));
            if (sample.inside < 0) continue;
            const float rim = smooth_step(0.0f, leaf.width * 0.2f, sample.inside);
            // The two halves of a leaf, left and right of the midrib, differ in brightness.
            const float side = s > 0 ? 1.04f : 0.94f;
            texel.color_srgb = leaf.color_srgb * (side * (0.8f + 0.2f * rim) * (1 + 0.28f * sample.rib));
            const float fold = std::abs(s) / leaf.width;
            texel.height_m = leaf.depth_m + (fold * 0.010f - sample.rib * 0.002f) + 0.002f * rim;
            texel.roughness = 0.48f + 0.1f * (1 - rim);
        }
    }
}

void draw_stalk(Surface& surface, glm::vec2 from, glm::vec2 to, float width, glm::vec3 color_srgb) {
    const glm::vec2 axis = to - from;
    const float length = glm::length(axis);
    const glm::vec2 along = axis / length;
    const float last = static_cast<float>(surface.size_px - 1);
    const glm::vec2 low = glm::clamp(glm::min(from, to) - width, glm::vec2(0), glm::vec2(last));
    const glm::vec2 high = glm::clamp(glm::max(from, to) + width, glm::vec2(0), glm::vec2(last));
    for (auto y = static_cast<uint32_t>(low.y); y <= static_cast<uint32_t>(high.y); ++y) {
        for (auto x = static_cast<uint32_t>(low.x); x <= static_cast<uint32_t>(high.x); ++x) {
            const glm::vec2 p = glm::vec2(x, y) - from;
            const float t = std::clamp(glm::dot(p, along), 0.0f, length);
            const float inside = width * 0.5f - glm::length(p - along * t);
            if (inside < -0.5f) continue;
            Texel& texel = surface.at(x, y);
            texel.alpha = std::max(texel.alpha, std::clamp(0.5f + inside, 0.0f, 1.0f));
            texel.color_srgb = color_srgb;
            texel.height_m = 0.001f;
            texel.roughness = 0.7f;
        }
    }
}

Surface blank_leaf_surface(uint32_t size_px, float period_m, glm::vec3 color_srgb) {
    Texel empty;
    empty.color_srgb = color_srgb;
    empty.roughness = 0.6f;
    empty.alpha = 0;
    return {size_px, period_m, std::vector<Texel>(static_cast<size_t>(size_px) * size_px, empty)};
}

}  // namespace weft::scene
