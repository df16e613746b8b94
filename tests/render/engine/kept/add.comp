#version 460
layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba32f) uniform image2D sum;
buffer Count { uint items[]; } count;

void main() {
    const ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    if (at == ivec2(0)) count.items[1] = count.items[1] + 1u;
    if (any(greaterThanEqual(at, imageSize(sum)))) return;
    imageStore(sum, at, imageLoad(sum, at) + vec4(1, 2, 3, 4));
}
