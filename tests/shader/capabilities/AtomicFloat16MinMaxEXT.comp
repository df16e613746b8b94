// refused: the SPIR-V gate must reject this shader on every device.
#version 460
#extension GL_EXT_shader_explicit_arithmetic_types_float16 : require
#extension GL_EXT_shader_atomic_float2 : require
#extension GL_EXT_shader_16bit_storage : require
layout(local_size_x = 8) in;
buffer Data { uint items[]; } data;
buffer Sums { float16_t sum; } sums;  // expected error line
void main() {
    atomicMax(sums.sum, float16_t(1));
}
