// Draws lines at silhouettes, steps and creases of surfaces. Depth is reversed: the distance of the near plane divided
// by the distance of the surface. On a flat surface this depth is linear in screen space, so its second difference is
// zero. It is large only at silhouettes and steps. At creases, the normals of neighbouring pixels differ.
#version 460
#include "octahedral.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

uniform sampler2D depth;
uniform sampler2D normal;
layout(rgba8) writeonly uniform image2D lines;

layout(push_constant) uniform Params {
    float penWidth;
} params;

ivec2 inside(ivec2 pixel) { return clamp(pixel, ivec2(0), imageSize(lines) - 1); }
float depth_at(ivec2 pixel) { return texelFetch(depth, inside(pixel), 0).r; }
vec3 normal_at(ivec2 pixel) { return octahedral_decode(texelFetch(normal, inside(pixel), 0).xy); }

float edge_along(ivec2 pixel, ivec2 step) {
    const float here = depth_at(pixel);
    const float a = depth_at(pixel - step);
    const float b = depth_at(pixel + step);
    const float fold = abs(a + b - 2.0 * here) / max(max(a, max(b, here)), 1e-6);
    const float bend = here > 0.0 ? 1.0 - dot(normal_at(pixel - step), normal_at(pixel + step)) : 0.0;
    return max(smoothstep(0.03, 0.12, fold), smoothstep(0.25, 0.7, bend));
}

void main() {
    const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, imageSize(lines)))) return;
    const int reach = max(1, int(params.penWidth * 0.5 + 0.5));
    float line = 0.0;
    for (int i = 1; i <= reach; ++i)
        line = max(line, max(edge_along(pixel, ivec2(i, 0)), edge_along(pixel, ivec2(0, i))));
    imageStore(lines, pixel, vec4(line));
}
