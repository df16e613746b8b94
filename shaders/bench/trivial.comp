// The cheapest useful pass over a picture, for `weft bench frame`: it reads one texel and writes one texel per pixel.
#version 460

layout(local_size_x = 8, local_size_y = 8) in;

uniform sampler2D ground;
layout(rgba16f) writeonly uniform image2D picture;

void main() {
    const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, imageSize(picture)))) return;
    imageStore(picture, pixel, texelFetch(ground, pixel, 0) * 0.5);
}
