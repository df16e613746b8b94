#version 460
// The shader declares no local size, so every workgroup has only one invocation.
layout(rgba8) writeonly uniform image2D dst;

void main() { imageStore(dst, ivec2(gl_GlobalInvocationID.xy), vec4(1.0)); }
