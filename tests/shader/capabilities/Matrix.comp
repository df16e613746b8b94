// allowed: the SPIR-V gate must accept this shader on every device.
#version 460
#extension GL_EXT_spirv_intrinsics : require
layout(local_size_x = 8) in;
buffer Data { uint items[]; } data;
spirv_instruction(capabilities = [0], id = 200)
uint twist(uint number);
void main() {
    data.items[0] = twist(1u);
}
