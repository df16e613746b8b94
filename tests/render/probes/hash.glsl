// Returns a number from 0 to 1 that depends on `key` in a way without a pattern.
float hash01(uvec3 key) {
    uint x = key.x * 0x9e3779b1u + key.y;
    x = (x ^ x >> 15) * 0x85ebca77u + key.z;
    x = (x ^ x >> 13) * 0xc2b2ae3du;
    return float((x ^ x >> 16) >> 8) / 16777216.0;
}
