// Multiplies the radiance of the surroundings by the basis functions of spherical harmonics, and adds up the texels of
// each part of a cube with 64 × 64 texels per face. A workgroup adds 1024 texels.
#version 460
#include "cube_texels.glsl"
#include "environment_cube.glsl"

layout(local_size_x = 128) in;

uniform sampler2DArray raw;
layout(std430) writeonly buffer Parts { vec4 items[]; } parts;  // 9 sums for each workgroup.

const uint kThreads = 128u, kTexels = 1024u, kSize = 64u;

shared vec3 sums[9][kThreads];

void main() {
    const uint thread = gl_LocalInvocationIndex;
    vec3 own[9];
    for (int i = 0; i < 9; ++i) own[i] = vec3(0.0);
    for (uint k = thread; k < kTexels; k += kThreads) {
        const uint index = gl_WorkGroupID.x * kTexels + k;
        const uvec3 at = uvec3(index % kSize, index / kSize % kSize, index / (kSize * kSize));
        const vec2 middle = face_position(at.xy, float(kSize));
        const float basis[9] = harmonic_basis(normalize(face_direction(at.z, middle)));
        const vec3 light = texelFetch(raw, ivec3(at), 0).rgb * texel_solid_angle(middle, float(kSize));
        for (int i = 0; i < 9; ++i) own[i] += light * basis[i];
    }
    for (int i = 0; i < 9; ++i) sums[i][thread] = own[i];
    for (uint half_count = kThreads / 2u; half_count > 0u; half_count /= 2u) {
        barrier();
        if (thread < half_count)
            for (int i = 0; i < 9; ++i) sums[i][thread] += sums[i][thread + half_count];
    }
    barrier();
    if (thread < 9u) parts.items[gl_WorkGroupID.x * 9u + thread] = vec4(sums[thread][0], 0.0);
}
