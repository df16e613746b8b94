// One slice of the hemisphere over a surface: the plane through the surface point and the eye, turned around the
// direction to the eye. An angle in the slice is measured from the direction to the eye, and is positive on the side of
// `across`. The part of the slice over the surface is divided into 32 sectors, one bit each. All sectors have the same
// share of the irradiance of a uniform sky.
//
// Sources: Jimenez et al. 2016, "Practical Realtime Strategies for Accurate Indirect Occlusion", for the integral over a
// slice with the cosine; Therrien, Levesque and Gilet 2023, "Screen Space Indirect Lighting with Visibility Bitmask".
#ifndef WEFT_SLICE
#define WEFT_SLICE

const float kHalfPi = 1.57079633;
const uint kSectors = 32u;

struct Slice {
    vec3 to_eye, across;  // Unit vectors, perpendicular to each other.
    float tilt;           // Angle of the normal's projection into the slice.
    float weight;         // Length of this projection.
    float begin, whole;   // slice_measure() of the first angle over the surface, and of all angles over it.
};

// Returns the integral of cos(angle − tilt) · |sin(angle)| from 0 to `angle`. |sin(angle)| is the width of the slice.
float slice_measure(float tilt, float angle) {
    const float side = angle < 0.0 ? -1.0 : 1.0, h = abs(angle), t = side * tilt;
    return side * 0.25 * (cos(t) - cos(2.0 * h - t) + 2.0 * h * sin(t));
}

Slice make_slice(vec3 to_eye, vec3 across, vec3 normal) {
    const vec2 projected = vec2(dot(normal, to_eye), dot(normal, across));
    Slice s;
    s.to_eye = to_eye;
    s.across = across;
    s.weight = length(projected);
    s.tilt = s.weight > 0.0 ? atan(projected.y, projected.x) : 0.0;
    s.begin = slice_measure(s.tilt, s.tilt - kHalfPi);
    s.whole = slice_measure(s.tilt, s.tilt + kHalfPi) - s.begin;
    return s;
}

// Returns the place of a direction in the slice, in sectors: 0 at the surface on the side opposite to `across`, 32 at the
// surface on the other side. `direction` is a unit vector on the side `side` (−1 or 1) of the direction to the eye.
float sector_of(Slice s, vec3 direction, float side) {
    const float angle = side * acos(clamp(dot(direction, s.to_eye), -1.0, 1.0));
    const float over = clamp(angle, s.tilt - kHalfPi, s.tilt + kHalfPi);
    return float(kSectors) * clamp((slice_measure(s.tilt, over) - s.begin) / s.whole, 0.0, 1.0);
}

// Returns the bits of the sectors whose place is between `low` and `high`. The place of sector i is i + offset.
uint sectors_between(float low, float high, float offset) {
    const uint begin = uint(ceil(clamp(low - offset, 0.0, 32.0))), end = uint(ceil(clamp(high - offset, 0.0, 32.0)));
    if (end <= begin) return 0u;
    const uint below_end = end >= 32u ? 0xffffffffu : (1u << end) - 1u;
    return below_end & (0xffffffffu << begin);
}
#endif
