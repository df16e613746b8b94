#version 460
layout(local_size_x = 1) in;
uniform sampler2D color;
writeonly buffer Total { uint channels[4]; } total;

void main() {
    const vec4 first = texelFetch(color, ivec2(0), 0);
    for (int i = 0; i < 4; ++i) total.channels[i] = uint(first[i] * 255.0);
}
