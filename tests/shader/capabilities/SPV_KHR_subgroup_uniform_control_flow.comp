// refused: the SPIR-V gate must reject this shader on every device.
#version 460
#extension GL_EXT_subgroup_uniform_control_flow : require  // expected error line
layout(local_size_x = 8) in;
buffer Data { uint items[]; } data;
void main()
[[subgroup_uniform_control_flow]]
{
    data.items[0] = 1u;
}
