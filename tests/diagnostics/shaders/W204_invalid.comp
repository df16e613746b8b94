#version 460
// the line above has the error W204
#extension GL_KHR_memory_scope_semantics : require
layout(local_size_x = 8, local_size_y = 8) in;
writeonly uniform image2D image;

void main() {
    controlBarrier(gl_ScopeDevice, gl_ScopeDevice, gl_StorageSemanticsBuffer, gl_SemanticsAcquireRelease);
    imageStore(image, ivec2(gl_GlobalInvocationID.xy), vec4(0.5));
}
