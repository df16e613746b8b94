// refused: the SPIR-V gate must reject this shader on every device.
#version 460
#extension GL_EXT_shader_16bit_storage : require
layout(local_size_x = 8) in;
buffer Data { uint items[]; } data;
layout(push_constant) uniform Params { uint16_t narrow; } params;  // expected error line
void main() {
    data.items[0] = uint(params.narrow);
}
