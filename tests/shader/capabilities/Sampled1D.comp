// interface: the SPIR-V gate must accept this shader on every device; it declares a variable.
#version 460
layout(local_size_x = 8) in;
buffer Data { uint items[]; } data;
uniform sampler1D source;
void main() {
    data.items[0] = uint(textureLod(source, 0.5, 0).x);
}
