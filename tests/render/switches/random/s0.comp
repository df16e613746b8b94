#version 460
layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba16f) writeonly uniform image2D dst;
layout(push_constant) uniform Params { uint frameIndex; } params;

void main() {
    const ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    imageStore(dst, at, vec4(0.125 + ((at.x + int(params.frameIndex)) & 7) / 16.0, at / 64.0, 1));
}
