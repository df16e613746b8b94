// refused: the SPIR-V gate must reject this shader on every device.
#version 460
#extension GL_EXT_shader_explicit_arithmetic_types_int64 : require
#extension GL_EXT_shader_image_int64 : require
layout(local_size_x = 8) in;
buffer Data { uint items[]; } data;
layout(r64ui) uniform u64image2D target;  // expected error line
void main() {
    imageAtomicAdd(target, ivec2(0), 1ul);
}
