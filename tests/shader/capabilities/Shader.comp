// allowed: the SPIR-V gate must accept this shader on every device.
#version 460
layout(local_size_x = 8) in;
buffer Data { uint items[]; } data;
void main() {
    data.items[0] = 1u;
}
