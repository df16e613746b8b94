// Rounds each component to the nearest half float, and returns it as a float. Drivers may round or truncate
// when they store a float to a half-float image, but all store a value unchanged if it already is a half
// float. For magnitudes below 65504.
#ifndef WEFT_HALF_FLOAT
#define WEFT_HALF_FLOAT
vec3 nearest_half(vec3 x) {
    // Half floats have 13 mantissa bits less; below their smallest normal number, 2⁻¹⁴, steps are 2⁻²⁴ wide.
    const vec3 normal = uintBitsToFloat((floatBitsToUint(x) + 0x1000u) & 0xFFFFE000u);
    const vec3 tiny = round(x * 16777216.0) / 16777216.0;
    return mix(normal, tiny, lessThan(abs(x), vec3(6.103515625e-5)));
}
#endif
