// refused: the SPIR-V gate must reject this shader on every device.
#version 460
#extension GL_KHR_memory_scope_semantics : require
#extension GL_NV_cooperative_matrix : require
layout(local_size_x = 8) in;
buffer Data { uint items[]; } data;
#pragma use_vulkan_memory_model
void main() {
    fcoopmatNV<32, gl_ScopeSubgroup, 8, 8> tile = fcoopmatNV<32, gl_ScopeSubgroup, 8, 8>(0);  // expected error line
    data.items[0] = uint(tile.length());
}
