// The entry for each light in the list of a super-tile, a square of 8 × 8 tiles. x: the light's index in 16
// bits, then one bit for each column and each row of tiles that it may reach, tested against their side
// planes. y: its range of distances along the view, as the upper halves of two floats, rounded outwards.
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
