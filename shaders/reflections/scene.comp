// Keeps the lit picture for the reflections of the next frame. Output ssrScene: rgb: the picture, × preExposure; a:
// depth of the surface along the view axis in metres, 0 for the sky.
#version 460
#include "frame_set.glsl"
#include "half_float.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

uniform sampler2D hdr;
uniform sampler2D depth;
layout(rgba16f) writeonly uniform image2D ssrScene;

void main() {
    const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, imageSize(ssrScene)))) return;
    const float z = texelFetch(depth, pixel, 0).r;
    const float away_m = z > 0.0 ? min(view.near_m / z, 65000.0) : 0.0;
    imageStore(ssrScene, pixel, vec4(nearest_half(min(texelFetch(hdr, pixel, 0).rgb, vec3(65000.0))), away_m));
}
