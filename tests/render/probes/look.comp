// Looks up the light of the probes along random lines. Each line has a normal, a direction to the eye and a mirrored
// direction. xyz of `place` is the point; w of `facing` is the validity.
#version 460
#include "hash.glsl"
#include "probes.glsl"

layout(local_size_x = 64) in;

layout(rgba32f) writeonly uniform image2D place;
layout(rgba32f) writeonly uniform image2D facing;
layout(rgba32f) writeonly uniform image2D mirrored;

vec3 random(uvec2 key) { return vec3(hash01(uvec3(key, 6u)), hash01(uvec3(key, 7u)), hash01(uvec3(key, 8u))); }

// Returns a place near a probe.
vec3 end_of_line(uvec2 key) {
    const uint probe = min(uint(hash01(uvec3(key, 9u)) * float(probeMap.items[1].z)), probeMap.items[1].z - 1u);
    return uintBitsToFloat(probeMap.items[kProbeGridItems + probe].xyz) + (random(key) - 0.5);
}

void main() {
    const ivec2 at = ivec2(gl_GlobalInvocationID.xy), size = imageSize(place);
    if (any(greaterThanEqual(at, size))) return;
    const uint line = uint(at.y);
    const vec3 point = mix(end_of_line(uvec2(line, 0u)), end_of_line(uvec2(line, 1u)), (float(at.x) + 0.5) / float(size.x));
    const vec3 n = normalize(random(uvec2(line, 2u)) - 0.5), eye = normalize(random(uvec2(line, 3u)) - 0.5);
    const ProbeLight light = probe_light(point, n, eye, n, normalize(random(uvec2(line, 4u)) - 0.5), vec3(0.0));
    imageStore(place, at, vec4(point, 1.0));
    imageStore(facing, at, vec4(light.facing, light.validity));
    imageStore(mirrored, at, vec4(light.mirrored, 1.0));
}
