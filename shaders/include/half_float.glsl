// The nearest half float to each component, as a float. Drivers may round or truncate when they store a float to a
// half-float image; what is a half float already is stored the same by all of them. For magnitudes below 65504.
#ifndef WEFT_HALF_FLOAT
#define WEFT_HALF_FLOAT
vec3 nearest_half(vec3 x) {
    // Half floats keep 13 bits of mantissa less; below their least normal number, 2⁻¹⁴, steps are 2⁻²⁴ wide.
    const vec3 normal = uintBitsToFloat((floatBitsToUint(x) + 0x1000u) & 0xFFFFE000u);
    const vec3 tiny = round(x * 16777216.0) / 16777216.0;
    return mix(normal, tiny, lessThan(abs(x), vec3(6.103515625e-5)));
}
#endif
