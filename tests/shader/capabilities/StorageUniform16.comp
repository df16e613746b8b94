// refused: the SPIR-V gate must reject this shader on every device.
#version 460
#extension GL_EXT_shader_16bit_storage : require
layout(local_size_x = 8) in;
buffer Data { uint items[]; } data;
uniform Halves { uint16_t narrow; } halves;  // expected error line
void main() {
    data.items[0] = uint(halves.narrow);
}
