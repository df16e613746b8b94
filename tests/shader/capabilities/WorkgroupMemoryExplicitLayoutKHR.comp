// refused: the SPIR-V gate must reject this shader on every device.
#version 460
layout(local_size_x = 8) in;
buffer Data { uint items[]; } data;
#extension GL_EXT_shared_memory_block : require  // expected error line
shared Block { uint value; } block;
void main() {
    block.value = 1u;
    data.items[0] = block.value;
}
