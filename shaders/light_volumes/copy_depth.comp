// Copies the depth image. Shaders read the copy while the original is attached as depth and stencil.
#version 460

layout(local_size_x = 8, local_size_y = 8) in;

uniform sampler2D depth;
layout(r32f) writeonly uniform image2D surfaceDepth;

void main() {
    const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, imageSize(surfaceDepth)))) return;
    imageStore(surfaceDepth, pixel, texelFetch(depth, pixel, 0));
}
