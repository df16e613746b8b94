#version 460
layout(local_size_x = 4, local_size_y = 4) in;
layout(push_constant) uniform Params { uint frameIndex; uint i; } params;
layout(r32f) writeonly uniform image2D dst;

void main() {
    imageStore(dst, ivec2(gl_GlobalInvocationID.xy), vec4(100 * params.i + params.frameIndex));
}
