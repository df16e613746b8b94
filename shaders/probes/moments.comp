// Makes the octahedral map of the distances that a probe sees, with which lookups find out whether the probe sees a
// point. r: mean of the inverse distance within the texel, g: its standard deviation. The inverse distance is 0 where
// nothing is, and it is nearly linear on planes, so that texels can be interpolated. The map has 16 × 16 texels and a
// border of one texel, which continues the map, so that a linear filter works across its edges.
#version 460
#include "cube_texels.glsl"
#include "octahedral.glsl"
#include "probe_map.glsl"

layout(local_size_x = 9, local_size_y = 9) in;

uniform sampler2DArray faces;
layout(rg32f) writeonly uniform image2D moments;

const int kSide = int(kProbeMomentSide);
const int kSamples = 8;  // Per side of a texel. A texel has the size of about 5 × 5 texels of a face with 32 × 32.

// Returns the texel of the map whose content a texel has. Texels of the border are copies.
ivec2 wrapped(ivec2 at) {
    if (at.x < 0 || at.x >= kSide) at = ivec2(clamp(at.x, 0, kSide - 1), kSide - 1 - at.y);
    if (at.y < 0 || at.y >= kSide) at = ivec2(kSide - 1 - at.x, clamp(at.y, 0, kSide - 1));
    return at;
}

float inverse_distance(vec3 direction) {
    const int size = textureSize(faces, 0).x;
    vec2 at;
    const int face = int(face_of_direction(direction, at));
    const ivec2 texel = min(ivec2((at * 0.5 + 0.5) * float(size)), size - 1);
    const float distance = abs(texelFetch(faces, ivec3(texel, face), 0).r);
    return distance > 0.0 ? 1.0 / distance : 0.0;
}

void main() {
    const ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(at, imageSize(moments)))) return;
    const ivec2 texel = wrapped(at - 1);
    vec3 sum = vec3(0.0);
    for (int i = 0; i < kSamples * kSamples; ++i) {
        const vec2 inside = (vec2(i % kSamples, i / kSamples) + 0.5) / float(kSamples);
        const vec2 e = (vec2(texel) + inside) / float(kSide) * 2.0 - 1.0;
        // The map is an octahedron laid flat. A piece of it looks smaller from the middle where it is farther away.
        vec3 corner = vec3(e, 1.0 - abs(e.x) - abs(e.y));
        if (corner.z < 0.0) corner.xy = (1.0 - abs(corner.yx)) * sign_not_zero(corner.xy);
        const float inverse_length = inversesqrt(dot(corner, corner));
        const float weight = inverse_length * inverse_length * inverse_length;
        const float near = inverse_distance(corner * inverse_length);
        sum += weight * vec3(1.0, near, near * near);
    }
    const float mean = sum.y / sum.x;
    imageStore(moments, at, vec4(mean, sqrt(max(sum.z / sum.x - mean * mean, 0.0)), 0.0, 0.0));
}
