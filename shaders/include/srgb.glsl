// Converts scene-linear values to display values. Curve: Narkowicz 2016, "ACES Filmic Tone Mapping Curve", a fit to the
// ACES reference rendering transform. Encoding: sRGB, IEC 61966-2-1.
#ifndef WEFT_SRGB
#define WEFT_SRGB

vec3 filmic(vec3 x) {
    return clamp((x * (2.51 * x + 0.03)) / (x * (2.43 * x + 0.59) + 0.14), 0.0, 1.0);
}

vec3 srgb_encode(vec3 c) {
    return mix(1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, 12.92 * c, lessThanEqual(c, vec3(0.0031308)));
}
#endif
