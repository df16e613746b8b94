// refused: the SPIR-V gate must reject this shader on every device.
#version 460
#extension GL_NV_shader_subgroup_partitioned : require
layout(local_size_x = 8) in;
buffer Data { uint items[]; } data;
void main() {
    data.items[0] = subgroupPartitionNV(1u).x;  // expected error line
}
