// refused: the SPIR-V gate must reject this shader on every device.
#version 460
layout(local_size_x = 8) in;
buffer Data { uint items[]; } data;
#extension GL_EXT_shared_memory_block : require  // expected error line
#extension GL_EXT_shader_explicit_arithmetic_types_int16 : require
shared Block { uint16_t value; } block;
void main() {
    data.items[0] = uint(block.value);
}
