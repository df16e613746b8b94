// Writes random harmonics and random planes for the test of the lookup.
#version 460
#include "hash.glsl"
#include "shared/probe_sh.glsl"

layout(local_size_x = 64) in;

layout(std430) writeonly buffer Sh { vec4 items[]; } probeSh;
layout(rgba16f) writeonly uniform image2DArray probeMoments;

layout(push_constant) uniform Params { uint blocked; float unlit; } params;

void main() {
    const uvec2 me = gl_GlobalInvocationID.xy;
    const uint probe = me.y;
    if (me.x >= 34u * 34u) return;
    if (me.x < 9u) {
        const bool lit = hash01(uvec3(probe, 90u, 0u)) >= params.unlit;
        // The first term is large, so that most sums are positive.
        vec3 value = vec3(hash01(uvec3(probe, me.x, 1u)), hash01(uvec3(probe, me.x, 2u)), hash01(uvec3(probe, me.x, 3u)));
        value = me.x == 0u ? 1.0 + value : value - 0.5;
        probeSh.items[kProbeShStride * probe + me.x] = vec4(value, lit ? 1.0 : 0.0);
    }
    const vec3 plane = 3.0 * (vec3(hash01(uvec3(probe, me.x, 4u)), hash01(uvec3(probe, me.x, 5u)), hash01(uvec3(probe, me.x, 6u))) - 0.5);
    const float deviation = 0.2 + 0.4 * hash01(uvec3(probe, me.x, 7u));
    imageStore(probeMoments, ivec3(me.x % 34u, me.x / 34u, probe), float(params.blocked) * vec4(plane, deviation));
}
