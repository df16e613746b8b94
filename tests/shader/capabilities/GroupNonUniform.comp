// compute: the SPIR-V gate must accept this compute shader on every device.
#version 460
#extension GL_KHR_shader_subgroup_basic : require
layout(local_size_x = 8) in;
buffer Data { uint items[]; } data;
void main() {
    data.items[0] = gl_SubgroupSize;
}
