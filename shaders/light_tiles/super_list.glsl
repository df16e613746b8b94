// Format of a light in the list of a super-tile (8 × 8 tiles). x contains the index of the light in 16 bits, then 8
// bits for columns and 8 bits for rows of tiles. A bit is 1 if the light may reach the column or row. y contains the
// nearest and farthest distance of the light along the view axis, as the upper halves of two floats, rounded outwards.
// Units: metres.

const int kTilesPerSide = 8;
const int kTilePx = 16;

uint super_index(uint light, uint columns, uint rows) { return light | columns << 16 | rows << 24; }

uint super_range(float near_m, float far_m) {
    return floatBitsToUint(max(near_m, 0.0)) >> 16 | ((floatBitsToUint(max(far_m, 0.0)) >> 16) + 1u) << 16;
}

uint light_of(uvec2 entry) { return entry.x & 0xFFFFu; }

float near_of(uvec2 entry) { return uintBitsToFloat(entry.y << 16); }

float far_of(uvec2 entry) { return uintBitsToFloat(entry.y & 0xFFFF0000u); }

bool holds_tile(uvec2 entry, uvec2 tile_in_super) {
    return (entry.x >> (16u + tile_in_super.x) & entry.x >> (24u + tile_in_super.y) & 1u) != 0u;
}
