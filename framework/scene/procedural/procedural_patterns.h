// Purpose: pieces of texture recipes: courses of blocks, marble veins, planks, weaves and leaf outlines.
// Units: positions are texels of a surface of `size` texels unless said otherwise; colours are
// display-encoded.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "scene/procedural/procedural_noise.h"
#include "scene/procedural/procedural_texture.h"

namespace weft::scene {

// Courses of equal blocks; each next course is shifted by `shift` of a block. Everything wraps.
struct BlockLayout {
    uint32_t columns = 3;
    uint32_t rows = 6;
    float shift = 0.5f;
};
struct Block {
    glm::vec2 local{0};  // 0..1 inside the block
    float edge_m = 0;    // distance to the nearest joint's centre
    uint32_t id = 0;
    uint32_t column = 0;
    uint32_t row = 0;
};
[[nodiscard]] Block block_at(const BlockLayout& layout, uint32_t x, uint32_t y, uint32_t size,
                             float period_m);

// Thin dark veins, 0 (none) to 1 (on a vein), warped by coarse noise; `offset` picks another part of the
// stone.
[[nodiscard]] float marble_vein(const NoiseBank& bank, uint32_t x, uint32_t y, uint32_t offset);

// Over and under threads of a plain weave: height 0..1 at a texel, `threads` across the surface.
[[nodiscard]] float weave_height(uint32_t x, uint32_t y, uint32_t size, uint32_t threads);

// Signed distance to the eight-pointed star made of two squares, and to a diamond; in the unit of `p`.
[[nodiscard]] float star_distance(glm::vec2 p, float radius);
[[nodiscard]] float diamond_distance(glm::vec2 p, float radius);

// Leaves drawn over one another into a surface whose alpha starts at 0. Lengths in texels, angles in radians.
enum class LeafShape : uint8_t { pointed, round, ivy, needle };
struct LeafStroke {
    glm::vec2 base{0};  // where the stalk joins
    float angle = 0;    // of the midrib; 0 points right, π/2 down
    float length = 100;
    float width = 40;
    LeafShape shape = LeafShape::pointed;
    glm::vec3 color_srgb{0.3f, 0.5f, 0.2f};
    float depth_m = 0;  // drawn later and higher lies on top
};
void draw_leaf(Surface& surface, const LeafStroke& leaf);
void draw_stalk(Surface& surface, glm::vec2 from, glm::vec2 to, float width, glm::vec3 color_srgb);
// Spreads the leaves' colour under the transparent texels, so that filtering brings in no dark rim.
[[nodiscard]] Surface blank_leaf_surface(uint32_t size_px, float period_m, glm::vec3 color_srgb);

}  // namespace weft::scene
