// Finds the lines of the picture. Output r: jumps of depth, where a surface ends; g: creases, where a surface bends.
// Jumps: depth is near plane / distance. On any plane, this value is linear in screen space, so its second difference
// is 0. At a jump, the second difference is large. The line is on the nearer side, `lineWidth` pixels wide.
// Creases: the normals of two pixels differ.
#version 460
#include "octahedral.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

uniform sampler2D depth;
uniform sampler2D normal;
layout(rg8) writeonly uniform image2D lines;

layout(push_constant) uniform Params {
    float lineWidth;  // Width of the lines, in pixels.
    float jump;       // Jump at which a line has half its strength: second difference / depth.
    float crease;     // Angle between two normals at which a line has half its strength, in degrees.
} params;

ivec2 inside(ivec2 pixel) { return clamp(pixel, ivec2(0), textureSize(depth, 0) - 1); }
float depth_at(ivec2 pixel) { return texelFetch(depth, inside(pixel), 0).r; }
vec3 normal_at(ivec2 pixel) { return octahedral_decode(texelFetch(normal, inside(pixel), 0).xy); }

void main() {
    const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, imageSize(lines)))) return;
    const int reach = max(1, int(round(params.lineWidth)));
    const ivec2 across[4] = ivec2[4](ivec2(1, 0), ivec2(0, 1), ivec2(1, 1), ivec2(1, -1));
    const float here = depth_at(pixel);
    float jump = 0.0, bend = 0.0;
    for (int i = 0; i < 4; ++i) {
        const ivec2 step_px = across[i] * reach;
        const float before = 2.0 * here - depth_at(pixel + step_px) - depth_at(pixel - step_px);
        jump = max(jump, before / max(here, 1e-6));
        if (i < 2) bend = max(bend, 1.0 - dot(normal_at(pixel), normal_at(pixel + step_px)));
    }
    const float silhouette = smoothstep(0.5, 1.5, jump / params.jump);
    const float fold = smoothstep(0.7, 1.3, bend / (1.0 - cos(radians(params.crease))));
    imageStore(lines, pixel, vec4(silhouette, here > 0.0 ? fold : 0.0, 0.0, 0.0));
}
