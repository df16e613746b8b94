// refused: the SPIR-V gate must reject this shader on every device.
#version 460
#extension GL_ARB_shader_clock : require
layout(local_size_x = 8) in;
buffer Data { uint items[]; } data;
void main() {
    data.items[0] = clock2x32ARB().x;  // expected error line
}
