// Constants and noise functions of the scene. Units: km. y points up, the water is at y = 0, the camera looks along +z.

const vec2 kLandCorner = vec2(-8.0, -1.0);
const float kLandSide = 16.0;
const vec3 kEye = vec3(0.15, 0.05, 0.0);
const float kFocal = 1.45;  // Focal length, in units of half the height of the picture.
const float kHighest = 2.1;

vec3 to_sun() { return normalize(vec3(-0.16, 0.105, 1.0)); }

vec2 land_uv(vec2 xz) { return (xz - kLandCorner) / kLandSide; }

uint bits_of(ivec2 p) {
    uint x = uint(p.x) * 0x9e3779b9u ^ uint(p.y) * 0x85ebca6bu;
    x = (x ^ (x >> 16)) * 0x7feb352du;
    x = (x ^ (x >> 15)) * 0x846ca68bu;
    return x ^ (x >> 16);
}

float corner(ivec2 p) { return float(bits_of(p) >> 8) / 16777216.0; }

// Returns smooth noise in [0, 1]. The random values are at integer coordinates and are interpolated between them.
float noise(vec2 p) {
    const vec2 cell = floor(p), f = p - cell;
    const vec2 s = f * f * f * (f * (f * 6.0 - 15.0) + 10.0);
    const ivec2 i = ivec2(cell);
    return mix(mix(corner(i), corner(i + ivec2(1, 0)), s.x),
               mix(corner(i + ivec2(0, 1)), corner(i + ivec2(1, 1)), s.x), s.y);
}

// Returns coordinates for the next octave: twice the frequency, rotated so that the lattices of octaves do not align.
vec2 finer(vec2 p) { return mat2(1.6, 1.2, -1.2, 1.6) * p + 17.3; }

// Adds octaves of noise, filtered for a pixel. `width` is the width of the area that the pixel covers, in the units of
// `p`. Octaves that are finer than this area are replaced by their mean, because they would flicker.
float soft_noise_within(vec2 p, int octaves, float width) {
    float sum = 0.0, share = 0.5;
    for (int i = 0; i < octaves; ++i, share *= 0.5, width *= 2.0, p = finer(p))
        sum += share * mix(noise(p), 0.5, smoothstep(0.3, 1.0, width));
    return sum;
}

float soft_noise(vec2 p, int octaves) {
    float sum = 0.0, share = 0.5;
    for (int i = 0; i < octaves; ++i, share *= 0.5, p = finer(p)) sum += share * noise(p);
    return sum;
}
