// One slice of the hemisphere over a surface: a plane that contains the surface point and the eye. The slices of a
// point are turned around the direction to the eye by different angles. An angle in the slice is measured from the
// direction to the eye, and is positive on the side of `across`. The half of the slice over the surface is divided into
// 32 sectors of equal angles, one bit each.
//
// Sources: Jimenez et al. 2016, "Practical Realtime Strategies for Accurate Indirect Occlusion", for the integral over a
// slice with the cosine; Therrien, Levesque and Gilet 2023, "Screen Space Indirect Lighting with Visibility Bitmask".
#ifndef WEFT_SLICE
#define WEFT_SLICE

const float kPi = 3.14159265;
const uint kSectors = 32u;

struct Slice {
    vec3 to_eye, across;  // Unit vectors, perpendicular to each other.
    float tilt;           // Angle of the normal's projection into the slice.
    float weight;         // Length of this projection.
};

// The light of a range of angles, if the sky is uniform: irradiance / π (measure), and the sum of the directions along
// to_eye (x) and across (y), weighted by the irradiance.
struct SliceLight {
    vec2 direction;
    float measure;
};

Slice make_slice(vec3 to_eye, vec3 across, vec3 normal) {
    const vec2 projected = vec2(dot(normal, to_eye), dot(normal, across));
    const float weight = length(projected);
    return Slice(to_eye, across, weight > 0.0 ? atan(projected.y, projected.x) : 0.0, weight);
}

// Returns the light between the angles 0 and `angle`, negative for negative angles: the integral of
// cos(angle − tilt) · |sin(angle)|. |sin(angle)| is the width of the slice.
SliceLight light_up_to(float tilt, float angle) {
    const float side = angle < 0.0 ? -1.0 : 1.0, h = abs(angle), c = cos(h), s = sin(h);
    const float ct = cos(tilt), st = side * sin(tilt), cube = s * s * s / 3.0;
    const float measure = 0.25 * (ct - (2.0 * c * c - 1.0) * ct - 2.0 * s * c * st + 2.0 * h * st);
    return SliceLight(vec2(side * (ct * (1.0 - c * c * c) / 3.0 + st * cube),
                           ct * cube + st * (2.0 / 3.0 - c + c * c * c / 3.0)),
                      side * measure);
}

// Returns the light of the sectors from `begin` to `end` − 1.
SliceLight light_of_sectors(Slice slice, uint begin, uint end) {
    const float sector = kPi / float(kSectors), first = slice.tilt - 0.5 * kPi;
    const SliceLight low = light_up_to(slice.tilt, first + float(begin) * sector);
    const SliceLight high = light_up_to(slice.tilt, first + float(end) * sector);
    return SliceLight(slice.weight * (high.direction - low.direction), slice.weight * (high.measure - low.measure));
}

// Returns the place of a direction in the slice, in sectors: 0 at the surface on the side opposite to `across`, 32 at the
// surface on the other side. `direction` is a unit vector on the side `side` (−1 or 1) of the direction to the eye.
float sector_of(Slice slice, vec3 direction, float side) {
    const float angle = side * acos(clamp(dot(direction, slice.to_eye), -1.0, 1.0));
    return float(kSectors) * clamp((angle - slice.tilt) / kPi + 0.5, 0.0, 1.0);
}

// Returns the bits from `begin` to `end` − 1.
uint bits_between(uint begin, uint end) {
    if (end <= begin) return 0u;
    return (end >= 32u ? 0xffffffffu : (1u << end) - 1u) & (0xffffffffu << begin);
}

// Returns the bits of the sectors whose place is between `low` and `high`. The place of sector i is i + offset.
uint sectors_between(float low, float high, float offset) {
    return bits_between(uint(ceil(clamp(low - offset, 0.0, 32.0))), uint(ceil(clamp(high - offset, 0.0, 32.0))));
}
#endif
