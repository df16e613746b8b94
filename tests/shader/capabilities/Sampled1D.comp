// interface: the SPIR-V gate and reflection must accept this shader and its variable on every device.
#version 460
layout(local_size_x = 8) in;
buffer Data { uint items[]; } data;
uniform sampler1D source;
void main() {
    data.items[0] = uint(textureLod(source, 0.5, 0).x);
}
