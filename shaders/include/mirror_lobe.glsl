// The lobe of directions from which a rough surface (GGX, height-correlated Smith) mirrors light to the eye, as a sum of
// three parts. The filtered cube has lobes for an eye that looks straight at the surface (N = V); these are round. At
// other angles, the lobe is longer in the plane of the normal and the eye, narrower across it, and not symmetric. Each
// part is a round lobe with a roughness of its own, and its middle lies in this plane.
#ifndef WEFT_MIRROR_LOBE
#define WEFT_MIRROR_LOBE

// The share of the light that each part mirrors.
const float kPartShares[3] = float[3](0.3211, 0.4145, 0.2644);

// Largest roughness for which the lobe has a single part.
const float kLeastParted = 0.1;

struct MirrorParts {
    // Tangents of the angles between the middles of the parts and the mirrored direction, divided by the sine of the
    // angle between the normal and the direction to the eye. Positive: away from the normal.
    vec3 tilts;
    vec3 roughnesses;
};

// The polynomials of n·v and the roughness r were fitted to the exact lobe for n·v from 0.1 to 1 and r from 0.2 to 1.
// The fit minimised the integral of |sum of the parts − lobe| over all directions. Each part had the shape that the
// mips of the cube give for the roughness of the part. Directions more than 35° off the mirrored direction counted up
// to three times as much, so that the sum keeps the tails of the lobe. The mean of the integral without these weights
// is 0.21; with a single part instead of three, it is 0.40. Below the roughness 0.2, the parts move towards each other.
// At the roughness kLeastParted, they become one part, because the cube has no narrower lobe.
MirrorParts mirror_parts(float r, float nv) {
    const float m = 0.5 - nv, s = r - 0.5;
    const float apart = clamp(10.0 * r - 1.0, 0.0, 1.0);
    MirrorParts parts;
    const vec3 tilts =
        vec3(0.3659, -0.8337, -3.7090) +
            m * (vec3(-2.1787, -1.6210, -8.0068) + m * (vec3(0.2004, -4.1291, -16.5196) + m * vec3(-6.1309, -3.9105, 0.0033))) +
        (vec3(-3.3642, -2.2898, -11.1142) + m * (vec3(0.3307, -4.8129, -38.2067) + m * vec3(5.6374, -6.4463, -46.7398))) * s +
        (vec3(0.2634, -1.9158, -10.2286) + m * vec3(12.4027, -4.2410, -41.4488)) * s * s +
        vec3(8.8351, -7.1653, 15.7171) * s * s * s;
    const vec3 widths =
        vec3(-0.5791, -0.4527, 0.6192) +
            m * (vec3(0.1682, 0.6479, -1.4706) + m * (vec3(0.8695, 0.6365, 11.2376) + m * vec3(-2.4997, -2.1003, -13.5719))) +
        (vec3(-0.3620, 1.1579, 3.6587) + m * (vec3(1.6522, -1.4477, -14.9411) + m * vec3(0.6097, 6.0103, 38.9316))) * s +
        (vec3(1.4939, 4.8600, 3.6474) + m * vec3(-3.5302, -13.4554, -26.2211)) * s * s +
        vec3(3.0682, 4.3843, 3.3751) * s * s * s;
    parts.tilts = (r * r * apart) * tilts;
    parts.roughnesses = clamp(r + (1.0 - nv) * apart * r * widths, min(r, kLeastParted), 1.0);
    return parts;
}
#endif
