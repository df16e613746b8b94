// refused: the SPIR-V gate must reject this shader on every device.
#version 460
#extension GL_AMD_shader_ballot : require
layout(local_size_x = 8) in;
buffer Data { uint items[]; } data;
void main() {
    data.items[0] = uint(addInvocationsAMD(1));  // expected error line
}
