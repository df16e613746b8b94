#version 460
layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba16f) writeonly uniform image2D dst;
layout(push_constant) uniform Params { float value; uint frameIndex; } params;

void main() {
    const ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    const float stripe = ((at.x + at.y + int(params.frameIndex)) & 7) / 32.0;
    imageStore(dst, at, vec4(params.value + stripe, at / 64.0, 1));
}
