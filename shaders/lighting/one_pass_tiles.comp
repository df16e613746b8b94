// Culls lights and shades pixels in one dispatch. A workgroup is a tile of 16 × 16 pixels. It finds the
// nearest and farthest depth of its surfaces, and tests the bounding sphere of each light against the four
// side planes of the tile and this depth range. Lights that pass both tests are called "passed lights". A light
// with unlimited range always passes. Then the workgroup adds to each pixel the light of the passed lights, of
// the directional lights (which are not tested) and of the sky. Sources: Andersson 2009, "Parallel Graphics in
// Frostbite"; White and Barré-Brisebois 2011, "More Performance!". Passed lights are bits in shared memory, and
// are processed in ascending order. So the order of additions is always the same, and no list can overflow.
// Output hdr: scene-linear Rec.709, cd/m² × preExposure, added to the emission. Output listed: number of passed
// lights per tile.
#version 460
layout(local_size_x = 16, local_size_y = 16) in;

#include "gbuffer_light.glsl"
#include "light_sphere.glsl"

layout(r32f) writeonly uniform image2D listed;

const uint kThreads = 256u;
const uint kMaxWords = 2048u;  // 32 lights per word, for the largest number of lights in a graph.

// Bits of the largest depth value of the tile (reversed depth, so this is the nearest) and of the smallest. Atomic
// operations on the bits work, because non-negative floats sort like their bits.
shared uint nearest_bits;
shared uint farthest_bits;
shared uint reaching[kMaxWords];  // One bit per tested light: 1 if it may reach the tile.

// Bounds of the surfaces of a tile in view space: normals of four planes through the eye, pointing inwards, and the
// range of distances along the view axis.
struct Tile {
    vec3 left, right, top, bottom;
    float near_m, far_m;
};

Tile make_tile(uvec2 at, vec2 size_px) {
    const vec2 low = vec2(at * 16u) / size_px * 2.0 - 1.0;
    const vec2 high = vec2(at * 16u + 16u) / size_px * 2.0 - 1.0;
    const mat4 p = view.projection;  // The third column contains the jitter, which shifts the picture.
    Tile tile;
    tile.left = normalize(vec3(p[0][0], 0.0, p[2][0] + low.x));
    tile.right = -normalize(vec3(p[0][0], 0.0, p[2][0] + high.x));
    tile.top = normalize(vec3(0.0, p[1][1], p[2][1] + low.y));
    tile.bottom = -normalize(vec3(0.0, p[1][1], p[2][1] + high.y));
    tile.near_m = view.near_m / uintBitsToFloat(nearest_bits);
    tile.far_m = view.near_m / uintBitsToFloat(farthest_bits);
    return tile;
}

bool reaches(Light light, Tile tile) {
    if (light.range_m <= 0.0) return true;
    const vec4 sphere = light_sphere(light);
    const vec3 center = (view.view * vec4(sphere.xyz, 1.0)).xyz;
    const float radius_m = sphere.w + 1e-4 * (sphere.w - center.z);  // The second term allows for rounding.
    const float sides = min(min(dot(tile.left, center), dot(tile.right, center)),
                            min(dot(tile.top, center), dot(tile.bottom, center)));
    return sides > -radius_m && -center.z - radius_m < tile.far_m && -center.z + radius_m > tile.near_m;
}

void find_depths(float z) {
    if (gl_LocalInvocationIndex == 0u) {
        nearest_bits = 0u;
        farthest_bits = floatBitsToUint(1.0);
    }
    barrier();
    if (z > 0.0) {
        atomicMax(nearest_bits, floatBitsToUint(z));
        atomicMin(farthest_bits, floatBitsToUint(z));
    }
    barrier();
}

// Tests the lights from index `first` to `count` − 1. Light first + i has bit i mod 32 of the word reaching[i / 32].
void cull(uint first, uint count, vec2 size_px) {
    const uint words = (count - first + 31u) / 32u;
    for (uint word = gl_LocalInvocationIndex; word < words; word += kThreads) reaching[word] = 0u;
    barrier();
    if (nearest_bits > 0u) {
        const Tile tile = make_tile(gl_WorkGroupID.xy, size_px);
        for (uint i = gl_LocalInvocationIndex; first + i < count; i += kThreads)
            if (reaches(lights.items[first + i], tile)) atomicOr(reaching[i >> 5], 1u << (i & 31u));
    }
    barrier();
}

vec3 lit_by_reaching(ivec2 pixel, vec3 position, uint first, uint count) {
    const vec3 material = texelFetch(orm, pixel, 0).rgb;
    const vec3 v = normalize(view.eye - position);
    const Surface s = with_albedo(gbuffer_surface(pixel, material), v);
    vec3 radiance = directional_reflection(s, v, position);
    for (uint word = 0u; first + word * 32u < count; ++word)
        for (uint bits = reaching[word]; bits != 0u; bits &= bits - 1u)
            radiance += lamp_reflection(s, v, position, lights.items[first + word * 32u + findLSB(bits)]);
    return radiance + material.r * ambient_reflection(s, v, material.g, position, pixel);
}

uint passed(uint words) {
    uint sum = 0u;
    for (uint word = 0u; word < words; ++word) sum += bitCount(reaching[word]);
    return sum;
}

void main() {
    const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    const ivec2 size = imageSize(hdr);
    const bool inside = all(lessThan(pixel, size));
    const float z = inside ? texelFetch(depth, pixel, 0).r : 0.0;
    const uint count = min(min(frame.light_count, uint(lights.items.length())), kMaxWords * 32u);
    const uint first = min(frame.directional_count, count);
    find_depths(z);
    cull(first, count, vec2(size));
    if (gl_LocalInvocationIndex == 0u)
        imageStore(listed, ivec2(gl_WorkGroupID.xy), vec4(passed((count - first + 31u) / 32u)));
    if (!inside) return;
    const vec2 uv = (vec2(pixel) + 0.5) / vec2(size);
    vec3 color;
    if (z > 0.0) {
        const vec3 lit = lit_by_reaching(pixel, world_position(uv, z), first, count);
        color = imageLoad(hdr, pixel).rgb + lit * frame.pre_exposure;
    } else {
        color = sky_light(uv);
    }
    store_light(pixel, color);
}
