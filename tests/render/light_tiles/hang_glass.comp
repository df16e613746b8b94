// Places glass panes in front of the scene. Writes the depth of the pane in each pixel, or 0 if no pane is visible.
#version 460
#include "frame_set.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

uniform sampler2D depth;
layout(r32f) writeonly uniform image2D glassDepth;

layout(push_constant) uniform Params { float glassStep_m; } params;

void main() {
    const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, imageSize(glassDepth)))) return;
    const uint pane = uint(pixel.x / 23 + 5 * (pixel.y / 19)) % 4u;
    const float pane_m = 1.0 + float(pane) * params.glassStep_m + 0.01 * float(pixel.x % 23);
    const float z = view.near_m / pane_m;
    imageStore(glassDepth, pixel, vec4(pane == 0u || z < texelFetch(depth, pixel, 0).r ? 0.0 : z));
}
