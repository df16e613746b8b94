// Writes the next smaller mip of a cube. The four texels are weighted by their solid angles.
#version 460
#include "cube_texels.glsl"
#include "half_float.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

uniform sampler2DArray src;
layout(rgba16f) writeonly uniform image2DArray dst;

void main() {
    const ivec3 at = ivec3(gl_GlobalInvocationID);
    const ivec3 size = imageSize(dst);
    if (any(greaterThanEqual(at, size))) return;
    vec4 sum = vec4(0.0);
    for (int i = 0; i < 4; ++i) {
        const ivec2 texel = at.xy * 2 + ivec2(i & 1, i >> 1);
        const float angle = texel_solid_angle(face_position(uvec2(texel), 2.0 * float(size.x)), 2.0 * float(size.x));
        sum += angle * vec4(texelFetch(src, ivec3(texel, at.z), 0).rgb, 1.0);
    }
    imageStore(dst, at, vec4(nearest_half(sum.rgb / sum.w), 1.0));
}
