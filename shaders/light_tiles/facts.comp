// Computes data about tiles for debug views, with one workgroup per tile. The code is not optimised for
// speed.
// Input: depth, hiz (mip with one texel per tile), lights, tileLights.
// Output tileFacts, for each pixel: r is the number of lights in the list of its tile, g is how many of these
// reach no surface in the tile. b is the number of depth slices of the tile that contain a surface, plus 0.5
// if this pixel is in a slice with an odd index. a is the cosine of the angle between the surface normal and
// the direction to the eye, at least 0.02; 0 for the sky.
#version 460
#include "frame_set.glsl"
#include "shared/light.glsl"

layout(local_size_x = 16, local_size_y = 16) in;

uniform sampler2D depth, hiz;
readonly buffer Lights { Light items[]; } lights;
layout(rgba16f) writeonly uniform image2D tileFacts;

#include "tile_lights.glsl"

const int kSlices = 32;

shared uint reached, occupied;

vec3 nearest_of(Light light, vec3 place) {
    const vec3 p = place - light.position, up = cross(light.side, light.direction);
    const vec2 size = light.half_size_m;
    if (light.type == kLightCapsule) return light.position + light.direction * clamp(dot(p, light.direction), -size.x, size.x);
    if (light.type != kLightRectangle) return light.position;
    return light.position + light.side * clamp(dot(p, light.side), -size.x, size.x) + up * clamp(dot(p, up), -size.y, size.y);
}

bool reaches(Light light, vec3 place) {
    const float along = dot(light.direction, place - light.position), distance_m = distance(place, light.position);
    if (light.type == kLightSpot && along * light.cone_scale <= -light.cone_offset * distance_m) return false;
    if (light.type == kLightRectangle && along <= 0.0) return false;
    return light.range_m <= 0.0 || distance(place, nearest_of(light, place)) < light.range_m;
}

// Tests 32 lights of the list, from index `first` on; each light is one bit of a word. Returns how many of these lights
// reach no pixel of the tile.
uint in_vain(uint list, uint first, uint end, vec3 place, bool surface) {
    if (gl_LocalInvocationIndex == 0u) reached = 0u;
    barrier();
    uint own = 0u;
    for (uint i = first; i < min(first + 32u, end) && surface; ++i)
        if (reaches(lights.items[tileLights.items[list + 1u + i]], place)) own |= 1u << (i - first);
    atomicOr(reached, own);
    barrier();
    const uint count = min(end - first, 32u) - uint(bitCount(reached));
    barrier();
    return count;
}

vec3 place_of(ivec2 pixel) {
    const float z = texelFetch(depth, pixel, 0).r;
    return world_position((vec2(pixel) + 0.5) * view.inverse_viewport, max(z, 1e-6));
}

// Returns the cosine of the angle between the surface normal and the direction to the eye, at least 0.02. Debug views
// draw edges where this cosine changes, so that the scene can be recognised.
float facing_eye(ivec2 pixel, ivec2 last, vec3 place) {
    const ivec2 beside = pixel + ivec2(pixel.x < last.x ? 1 : -1, 0), below = pixel + ivec2(0, pixel.y < last.y ? 1 : -1);
    const vec3 normal = cross(place_of(beside) - place, place_of(below) - place);
    return max(abs(dot(normal, place - view.eye)) / max(length(normal) * length(place - view.eye), 1e-12), 0.02);
}

void main() {
    const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy), last = ivec2(view.viewport_px) - 1;
    const float z = all(lessThanEqual(pixel, last)) ? texelFetch(depth, pixel, 0).r : 0.0;
    const vec2 range = texelFetch(hiz, ivec2(gl_WorkGroupID.xy), 0).rg;
    const vec3 place = place_of(min(pixel, last));
    const float near_m = view.near_m / range.x, far_m = view.near_m / range.y;
    const int slice = z > 0.0 ? int(clamp((view.near_m / z - near_m) / (far_m - near_m + 1e-6) * kSlices, 0.0, kSlices - 1)) : 0;
    if (gl_LocalInvocationIndex == 0u) occupied = 0u;
    barrier();
    if (z > 0.0) atomicOr(occupied, 1u << slice);
    const uint list = tile_list(min(pixel, last)), count = tileLights.items[list];
    uint vain = 0u;
    for (uint first = 0u; first < count; first += 32u) vain += in_vain(list, first, count, place, z > 0.0);
    barrier();
    const float slices = float(bitCount(occupied)) + 0.5 * float(slice & 1);
    const float relief = z > 0.0 ? facing_eye(pixel, last, place) : 0.0;
    if (all(lessThanEqual(pixel, last))) imageStore(tileFacts, pixel, vec4(count, vain, slices, relief));
}
