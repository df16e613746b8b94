// Purpose: building blocks for texture recipes: rows of blocks, marble veins, planks, weaves and leaf
// outlines. Units: positions are texels of a surface of `size` texels unless stated otherwise; colours are
// display-encoded.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "scene/procedural/procedural_noise.h"
#include "scene/procedural/procedural_texture.h"

namespace weft::scene {

// Rows of equal blocks; each row is shifted by `shift` of a block against the previous one. The pattern
// wraps.
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

// Height (0..1) of a plain weave at a texel; the surface has `threads` threads per side.
[[nodiscard]] float weave_height(uint32_t x, uint32_t y, uint32_t size, uint32_t threads);

// Signed distance to an eight-pointed star made of two squares, and to a diamond; in the unit of `p`.
[[nodiscard]] float star_distance(glm::vec2 p, float radius);
[[nodiscard]] float diamond_distance(glm::vec2 p, float radius);

// Leaves are drawn on top of each other into a surface whose alpha starts at 0. Lengths in texels, angles in
// radians.
enum class LeafShape : uint8_t { pointed, round, ivy, needle };
struct LeafStroke {
    glm::vec2 base{0};  // the joint with the stalk
    float angle = 0;    // direction of the midrib; 0 points right, π/2 down
    float length = 100;
    float width = 40;
    LeafShape shape = LeafShape::pointed;
    glm::vec3 color_srgb{0.3f, 0.5f, 0.2f};
    float depth_m = 0;  // a leaf drawn later covers earlier ones if it is higher
};
void draw_leaf(Surface& surface, const LeafStroke& leaf);
void draw_stalk(Surface& surface, glm::vec2 from, glm::vec2 to, float width, glm::vec3 color_srgb);
// A surface with the leaves' colour in its transparent texels, so that filtering causes no dark edges.
[[nodiscard]] Surface blank_leaf_surface(uint32_t size_px, float period_m, glm::vec3 color_srgb);

}  // namespace weft::scene
