// compute+device: the SPIR-V gate must accept this shader only if the device supports GroupNonUniformVote.
#version 460
#extension GL_KHR_shader_subgroup_vote : require
layout(local_size_x = 8) in;
buffer Data { uint items[]; } data;
void main() {
    data.items[0] = uint(subgroupAll(true));  // expected error line
}
