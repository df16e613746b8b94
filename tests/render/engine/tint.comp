#version 460
layout(local_size_x = 8, local_size_y = 8) in;
uniform sampler2D paint;
uniform sampler2D drawn;
layout(rgba32f) writeonly uniform image2D canvas;

void main() {
    const ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(at, imageSize(canvas)))) return;
    imageStore(canvas, at, texelFetch(paint, at % textureSize(paint, 0), 0) + texelFetch(drawn, ivec2(0), 0));
}
