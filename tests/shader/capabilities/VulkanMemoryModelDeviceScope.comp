// refused: the SPIR-V gate must reject this shader on every device.
#version 460
#extension GL_KHR_memory_scope_semantics : require
layout(local_size_x = 8) in;
buffer Data { uint items[]; } data;
#pragma use_vulkan_memory_model  // expected error line
void main() {
    atomicAdd(data.items[0], 1u, gl_ScopeDevice, gl_StorageSemanticsBuffer, gl_SemanticsRelaxed);
}
