// compute+device: the SPIR-V gate must accept this shader only if the device supports GroupNonUniformQuad.
#version 460
#extension GL_KHR_shader_subgroup_quad : require
layout(local_size_x = 8) in;
buffer Data { uint items[]; } data;
void main() {
    data.items[0] = subgroupQuadSwapHorizontal(1u);  // expected error line
}
