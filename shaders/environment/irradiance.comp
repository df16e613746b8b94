// Writes irradiance / π to each texel of a cube; the direction of the texel is the normal. The result is the mean of
// all texels of the raw cube's mip with 32 × 32 texels per face, weighted by their solid angles and by the cosine of
// the angle to the normal.
#version 460
#include "cube_texels.glsl"
#include "half_float.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

uniform sampler2DArray raw;  // The mip with 32 × 32 texels per face.
layout(rgba16f) writeonly uniform image2DArray dst;

const uint kThreads = 64u, kSize = 32u, kBatch = 512u;

shared vec4 beams[kBatch];  // Direction and solid angle of a texel of `raw`.
shared vec3 radiances[kBatch];

void load_batch(uint first) {
    for (uint k = gl_LocalInvocationIndex; k < kBatch; k += kThreads) {
        const uint index = first + k;
        const uvec3 at = uvec3(index % kSize, index / kSize % kSize, index / (kSize * kSize));
        const vec2 middle = face_position(at.xy, float(kSize));
        beams[k] = vec4(normalize(face_direction(at.z, middle)), texel_solid_angle(middle, float(kSize)));
        radiances[k] = texelFetch(raw, ivec3(at), 0).rgb;
    }
}

void main() {
    const uvec3 at = gl_GlobalInvocationID;
    const vec3 n = normalize(face_direction(at.z, face_position(at.xy, float(imageSize(dst).x))));
    vec4 sum = vec4(0.0);
    for (uint first = 0u; first < 6u * kSize * kSize; first += kBatch) {
        barrier();
        load_batch(first);
        barrier();
        for (uint k = 0u; k < kBatch; ++k)
            sum += max(dot(n, beams[k].xyz), 0.0) * beams[k].w * vec4(radiances[k], 1.0);
    }
    imageStore(dst, ivec3(at), vec4(nearest_half(sum.rgb / sum.w), 1.0));
}
