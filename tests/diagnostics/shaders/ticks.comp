#version 460
layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba8) writeonly uniform image2D table;
layout(push_constant) uniform Params { uint frameIndex; } params;

void main() { imageStore(table, ivec2(gl_GlobalInvocationID.xy), vec4(float(params.frameIndex % 2u))); }
