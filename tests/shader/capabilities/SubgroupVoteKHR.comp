// refused: the SPIR-V gate must reject this shader on every device.
#version 460
#extension GL_ARB_shader_group_vote : require
layout(local_size_x = 8) in;
buffer Data { uint items[]; } data;
void main() {
    data.items[0] = uint(anyInvocationARB(true));  // expected error line
}
