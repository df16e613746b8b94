// Computes the mean of the mirrored light over the rays of neighbouring texels. A ray has the weight BRDF · cosine /
// density, as seen from this texel. The sum is divided by the sum of the weights (ratio estimator), so uniform light
// stays uniform. Source: Stachowiak 2015, "Stochastic Screen-Space Reflections".
// Output ssrMean: rgb: radiance × preExposure × confidence; a: confidence. Output ssrReach: x: mean length of the rays
// with a hit, in metres; 0: no hit. Output ssrOpen, of the rays without a hit: x: 1 / the distance for which nothing is
// in their way, in 1/m; yzw: radiance of the surroundings × preExposure.
#version 460
#include "brdf.glsl"
#include "frame_set.glsl"
#include "half_float.glsl"
#include "ray.glsl"
#include "tiles.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(std430) readonly buffer Tiles { uint items[]; } tiles;  // Those with a texel that reflects.
uniform sampler2D ssrSurface;
uniform usampler2DArray ssrRay;
uniform sampler2DArray ssrLight;
layout(rgba16f) writeonly uniform image2D ssrMean;
layout(r16f) writeonly uniform image2D ssrReach;
layout(rgba16f) writeonly uniform image2D ssrOpen;

layout(push_constant) uniform Params {
    uint ssrScale;
    uint ssrNeighbours;  // Number of texels whose rays are used, a square number.
} params;

// A neighbour belongs to the same surface if three conditions are met: its distance from the plane of the surface is
// below kPlaneShare times the distance to the eye, the cosine of the angle between the normals is above kLeastCosine,
// and the roughness differs by less than kSameRoughness.
const float kPlaneShare = 0.01, kLeastCosine = 0.9, kSameRoughness = 0.1;
// Smallest distance without objects whose inverse is stored.
const float kLeastFree_m = 1e-3;

struct Reflector {
    vec3 position, normal, to_eye;
    float distance_m, roughness, alpha;
};

vec3 position_of(ivec2 texel, float z) {
    return world_position((vec2(texel * int(params.ssrScale)) + 0.5) * view.inverse_viewport, z);
}

// Returns how much the neighbour `at` belongs to the same surface, 0 to 1.
float alike(Reflector own, vec4 surface, vec3 position) {
    if (surface.z <= 0.0 || surface.w >= kNoRays) return 0.0;
    const float off = abs(dot(position - own.position, own.normal)) / (kPlaneShare * own.distance_m);
    const float facing = smoothstep(kLeastCosine, 1.0, dot(own.normal, octahedral_decode(surface.xy)));
    return max(1.0 - off, 0.0) * facing * max(1.0 - abs(surface.w - own.roughness) / kSameRoughness, 0.0);
}

// Returns BRDF · cosine / density for a ray of a neighbour, without the Fresnel term. `origin`: of the ray.
float weight_of(Reflector own, Ray ray, vec3 origin) {
    if (ray.pdf <= 0.0) return 0.0;
    if (own.alpha < kMirrorAlpha) return 1.0;
    const vec3 way = ray.length_m > 0.0 ? origin + ray.direction * ray.length_m - own.position : ray.direction;
    const vec3 l = normalize(way), h = normalize(l + own.to_eye);
    const float nl = dot(own.normal, l), nv = max(dot(own.normal, own.to_eye), 1e-4);
    if (nl <= 0.0) return 0.0;
    return ggx_distribution(own.alpha, own.normal, h) * smith_visibility(own.alpha, nl, nv) * nl / ray.pdf;
}

// Sums over rays. hits, opens: the weights of the rays with and without a hit.
struct Gathered {
    vec4 light, open;
    float hits, opens, reach;
};

void add_rays(inout Gathered sum, Reflector own, ivec2 at, vec3 origin, float same) {
    const int rays = textureSize(ssrRay, 0).z;
    for (int i = 0; i < rays; ++i) {
        const Ray ray = unpacked_ray(texelFetch(ssrRay, ivec3(at, i), 0).xy);
        const float weight = same * weight_of(own, ray, origin);
        const vec4 light = texelFetch(ssrLight, ivec3(at, i), 0);
        if (ray.length_m > 0.0) {
            sum.light += weight * light;
            sum.reach += weight * ray.length_m;
            sum.hits += weight;
        } else {
            sum.opens += weight;
            sum.open += weight * vec4(1.0 / max(-ray.length_m, kLeastFree_m), light.rgb);
        }
    }
}

Gathered gather(ivec2 texel, vec4 surface) {
    const vec3 position = position_of(texel, surface.z);
    const float distance_m = distance(position, view.eye);
    const Reflector own = Reflector(position, octahedral_decode(surface.xy), (view.eye - position) / distance_m,
                                    distance_m, surface.w, alpha_of(surface.w));
    const int side = side_of_neighbours(own.roughness, params.ssrNeighbours);
    // The middle of a window with an even side is not a texel, so the window moves from frame to frame.
    const ivec2 turn = ivec2(frame.frame_index & 1u, frame.frame_index >> 1 & 1u);
    const ivec2 first = texel - side / 2 + (side % 2 == 0 ? turn : ivec2(0));
    const ivec2 last = textureSize(ssrSurface, 0) - 1;
    Gathered sum = Gathered(vec4(0.0), vec4(0.0), 0.0, 0.0, 0.0);
    for (int i = 0; i < side * side; ++i) {
        const ivec2 at = first + ivec2(i % side, i / side);
        if (any(lessThan(at, ivec2(0))) || any(greaterThan(at, last))) continue;
        const vec4 other = texelFetch(ssrSurface, at, 0);
        const vec3 origin = position_of(at, other.z);
        const float same = at == texel ? 1.0 : alike(own, other, origin);
        if (same > 0.0) add_rays(sum, own, at, origin, same);
    }
    return sum;
}

void main() {
    const uint at = place_in_list();
    if (at >= tiles.items[3]) return;
    const ivec2 size = imageSize(ssrMean);
    const ivec2 texel = texel_of_tile(tiles.items[kTilesBegin + at], size);
    if (any(greaterThanEqual(texel, size))) return;
    const vec4 surface = texelFetch(ssrSurface, texel, 0);
    Gathered sum = Gathered(vec4(0.0), vec4(0.0), 0.0, 0.0, 0.0);
    if (surface.z > 0.0 && surface.w < kNoRays) sum = gather(texel, surface);
    const float all = sum.hits + sum.opens;
    const vec4 mean = all > 0.0 ? sum.light / all : vec4(0.0);
    imageStore(ssrMean, texel, vec4(nearest_half(min(mean.rgb, vec3(65000.0))), mean.a));
    imageStore(ssrReach, texel, vec4(sum.hits > 0.0 ? sum.reach / sum.hits : 0.0));
    imageStore(ssrOpen, texel, sum.opens > 0.0 ? sum.open / sum.opens : vec4(0.0));
}
