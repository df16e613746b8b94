// Purpose: building blocks for texture recipes: rows of blocks, marble veins, weaves, stars, diamonds and
// leaves. Units: positions are in texels, on a surface of `size` × `size` texels, unless stated otherwise;
// colours are display-encoded.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "scene/procedural/procedural_noise.h"
#include "scene/procedural/procedural_texture.h"

namespace weft::scene {

// A pattern of equal blocks in rows. Each row is shifted against the previous row by `shift` times the width
// of a block. The pattern repeats at the edges of the texture.
struct BlockLayout {
    uint32_t columns = 3;
    uint32_t rows = 6;
    float shift = 0.5f;
};
struct Block {
    glm::vec2 local{0};  // Position inside the block; both coordinates go from 0 to 1.
    float edge_m = 0;    // Distance to the centre line of the nearest joint between blocks, in metres.
    uint32_t id = 0;     // Hash of `column` and `row`.
    uint32_t column = 0;
    uint32_t row = 0;
};
// Returns the block at texel (x, y). `period_m` is the side of the whole texture in metres.
[[nodiscard]] Block block_at(const BlockLayout& layout, uint32_t x, uint32_t y, uint32_t size,
                             float period_m);

// Returns the strength of marble's thin dark veins at a texel: 0 is no vein, 1 is the middle of a vein. Noise
// distorts the veins. `offset` selects another part of the stone.
[[nodiscard]] float marble_vein(const NoiseBank& bank, uint32_t x, uint32_t y, uint32_t offset);

// Returns the height (0..1) of a plain weave at a texel. The surface has `threads` threads per side.
[[nodiscard]] float weave_height(uint32_t x, uint32_t y, uint32_t size, uint32_t threads);

// Returns the distance from `p` to the outline of an eight-pointed star made of two squares, in the unit of
// `p`; negative inside. The star has its centre at (0, 0), and `radius` is the distance from the centre to a
// tip. diamond_distance() does the same for a diamond. Near the tips, outside the shape, the results are
// smaller than the true distance.
[[nodiscard]] float star_distance(glm::vec2 p, float radius);
[[nodiscard]] float diamond_distance(glm::vec2 p, float radius);

// Shapes of leaves. draw_leaf() draws leaves on top of each other into a surface whose alpha starts at 0.
// Lengths are in texels, angles in radians.
enum class LeafShape : uint8_t { pointed, round, ivy, needle };
struct LeafStroke {
    glm::vec2 base{0};  // Position of the joint between leaf and stalk, in texels.
    float angle = 0;    // Direction of the midrib: 0 points right, π/2 points down.
    float length = 100;
    float width = 40;
    LeafShape shape = LeafShape::pointed;
    glm::vec3 color_srgb{0.3f, 0.5f, 0.2f};
    // Height of the leaf above the surface. The height affects only the normal map: a leaf that is drawn
    // later always covers the leaves before it.
    float depth_m = 0;
};
void draw_leaf(Surface& surface, const LeafStroke& leaf);
void draw_stalk(Surface& surface, glm::vec2 from, glm::vec2 to, float width, glm::vec3 color_srgb);
// Makes a transparent surface whose texels have the colour of the leaves. So filtering at the edges of leaves
// causes no dark rims.
[[nodiscard]] Surface blank_leaf_surface(uint32_t size_px, float period_m, glm::vec3 color_srgb);

}  // namespace weft::scene
