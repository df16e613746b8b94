// Rounds each component to the nearest half float. When drivers store a float in a half-float image, some round and
// some truncate. A value that already is a half float is stored unchanged by all drivers, so the difference disappears.
// Magnitudes must be below 65504.
#ifndef WEFT_HALF_FLOAT
#define WEFT_HALF_FLOAT
vec3 nearest_half(vec3 x) {
    // The mantissa of a half float is 13 bits shorter than that of a float. 2⁻¹⁴ is the smallest normal half
    // float; below it, neighbouring half floats differ by 2⁻²⁴.
    const vec3 normal = uintBitsToFloat((floatBitsToUint(x) + 0x1000u) & 0xFFFFE000u);
    const vec3 tiny = round(x * 16777216.0) / 16777216.0;
    return mix(normal, tiny, lessThan(abs(x), vec3(6.103515625e-5)));
}
#endif
