#version 460
// No layout(local_size_x = 8) in; so every workgroup is one invocation.
layout(rgba8) writeonly uniform image2D dst;

void main() { imageStore(dst, ivec2(gl_GlobalInvocationID.xy), vec4(1.0)); }
