// Multiplies the radiance that a light probe sees by the basis functions of spherical harmonics, adds up all texels of
// its six faces, and writes the coefficients of irradiance / π in cd/m². One workgroup adds all texels.
#version 460
#include "cube_texels.glsl"
#include "environment_cube.glsl"
#include "shared/probe_sh.glsl"

layout(local_size_x = 128) in;

uniform sampler2DArray lit;
layout(std430) writeonly buffer Harmonics { vec4 items[]; } harmonics;  // The elements of this probe in `probeSh`.

const uint kThreads = 128u;

shared vec3 sums[9][kThreads];

void main() {
    const uint thread = gl_LocalInvocationIndex;
    const uint size = uint(textureSize(lit, 0).x), texels = 6u * size * size;
    vec3 own[9];
    for (int i = 0; i < 9; ++i) own[i] = vec3(0.0);
    for (uint k = thread; k < texels; k += kThreads) {
        const uvec3 at = uvec3(k % size, k / size % size, k / (size * size));
        const vec2 middle = face_position(at.xy, float(size));
        const float basis[9] = harmonic_basis(normalize(face_direction(at.z, middle)));
        const vec3 light = texelFetch(lit, ivec3(at), 0).rgb * texel_solid_angle(middle, float(size));
        for (int i = 0; i < 9; ++i) own[i] += light * basis[i];
    }
    for (int i = 0; i < 9; ++i) sums[i][thread] = own[i];
    for (uint half_count = kThreads / 2u; half_count > 0u; half_count /= 2u) {
        barrier();
        if (thread < half_count)
            for (int i = 0; i < 9; ++i) sums[i][thread] += sums[i][thread + half_count];
    }
    barrier();
    if (thread >= kProbeShStride) return;
    const vec3 sum = thread < 9u ? sums[thread][0] * kIrradianceFactors[thread] : vec3(0.0);
    harmonics.items[thread] = vec4(sum, thread == 0u ? 1.0 : 0.0);
}
