// The rays of the reflections, and how they are stored.
#ifndef WEFT_REFLECTION_RAY
#define WEFT_REFLECTION_RAY
#include "brdf.glsl"
#include "octahedral.glsl"
#include "screen_reflections.glsl"

// A ray from a texel.
struct Ray {
    vec3 direction;
    float length_m;  // Distance to the hit. Without a hit: minus the distance for which nothing is in the way.
    float pdf;       // Probability density of the direction in 1/sr. 0: the texel has no ray.
};

const float kFar_m = 10000.0;   // Longest distance that is stored.
const float kNoRay = -1000.0;   // Replaces log2 of the density if the texel has no ray.
const Ray kRayOfNone = Ray(vec3(0.0, 1.0, 0.0), 0.0, 0.0);
uvec2 packed_ray(Ray ray) {
    return uvec2(packSnorm2x16(octahedral_encode(ray.direction)),
                 packHalf2x16(vec2(clamp(ray.length_m, -kFar_m, kFar_m), ray.pdf > 0.0 ? log2(ray.pdf) : kNoRay)));
}

Ray unpacked_ray(uvec2 words) {
    const vec2 numbers = unpackHalf2x16(words.y);
    return Ray(octahedral_decode(unpackSnorm2x16(words.x)), numbers.x, numbers.y > kNoRay ? exp2(numbers.y) : 0.0);
}

// Returns the number of texels along each side of the square whose rays a texel uses. `neighbours`: ssrNeighbours, a
// square number. If the surface is smooth, the lobes of neighbours hardly overlap, and a texel uses only its own rays.
int side_of_neighbours(float roughness, uint neighbours) {
    const float kNarrow = 0.15;
    return roughness < kNarrow ? 1 : int(sqrt(float(neighbours)) + 0.5);
}

float alpha_of(float roughness) { return max(roughness * roughness, kMinAlpha); }
#endif
