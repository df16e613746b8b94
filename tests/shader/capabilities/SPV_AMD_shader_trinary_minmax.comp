// refused: the SPIR-V gate must reject this shader on every device.
#version 460
layout(local_size_x = 8) in;
buffer Data { uint items[]; } data;
#extension GL_AMD_shader_trinary_minmax : require  // expected error line
void main() {
    data.items[0] = max3(1u, data.items[0], 2u);
}
