// allowed: the SPIR-V gate must accept this shader on every device.
#version 460
layout(local_size_x = 8) in;
buffer Data { uint items[]; } data;
uniform sampler2D source;
void main() {
    data.items[0] = uint(textureSize(source, 0).x);
}
