// compute+device: the SPIR-V gate must accept this shader only if the device supports GroupNonUniformShuffleRelative.
#version 460
#extension GL_KHR_shader_subgroup_shuffle_relative : require
layout(local_size_x = 8) in;
buffer Data { uint items[]; } data;
void main() {
    data.items[0] = subgroupShuffleUp(1u, 2u);  // expected error line
}
