// refused: the SPIR-V gate must reject this shader on every device.
#version 460
#extension GL_EXT_shader_explicit_arithmetic_types_int64 : require
#extension GL_EXT_shader_atomic_int64 : require
layout(local_size_x = 8) in;
buffer Data { uint items[]; } data;
buffer Sums { uint64_t sum; } sums;  // expected error line
void main() {
    atomicAdd(sums.sum, 1ul);
}
