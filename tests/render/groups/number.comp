#version 460
layout(local_size_x = 8, local_size_y = 8) in;
layout(push_constant) uniform Params { float value; } params;
layout(r32f) writeonly uniform image2D dst;

void main() { imageStore(dst, ivec2(gl_GlobalInvocationID.xy), vec4(params.value)); }
