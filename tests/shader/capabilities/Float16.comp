// refused: the SPIR-V gate must reject this shader on every device.
#version 460
#extension GL_EXT_shader_explicit_arithmetic_types_float16 : require
layout(local_size_x = 8) in;
buffer Data { uint items[]; } data;
void main() {
    float16_t sum = float16_t(data.items[0]);  // expected error line
    data.items[0] = uint(sum);
}
