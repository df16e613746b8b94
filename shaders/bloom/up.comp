// Blends the next smaller mip into this mip, in place. This spreads part of the light over a wider area. The total
// light does not increase.
#version 460
#include "half_float.glsl"
#include "tent.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

uniform sampler2D coarse;
layout(rgba16f) uniform image2D bloom;

layout(push_constant) uniform Params { float bloomSpread; } params;  // Weight of the smaller mip, 0 to 1.

void main() {
    const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, imageSize(bloom)))) return;
    const vec3 wide = tent(coarse, (vec2(pixel) + 0.5) / vec2(imageSize(bloom)));
    imageStore(bloom, pixel, vec4(nearest_half(mix(imageLoad(bloom, pixel).rgb, wide, params.bloomSpread)), 1.0));
}
