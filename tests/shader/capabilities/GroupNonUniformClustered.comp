// compute+device: the SPIR-V gate must accept this shader only if the device supports GroupNonUniformClustered.
#version 460
#extension GL_KHR_shader_subgroup_clustered : require
layout(local_size_x = 8) in;
buffer Data { uint items[]; } data;
void main() {
    data.items[0] = subgroupClusteredAdd(1u, 4u);  // expected error line
}
