#version 460
layout(local_size_x = 8, local_size_y = 8) in;
layout(push_constant) uniform Params { vec2 dstSize; uint beforeValid; } params;
uniform sampler2D before;
layout(rgba32f) writeonly uniform image2D dst;

void main() {
    const ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(at, ivec2(params.dstSize)))) return;
    const vec2 uv = (vec2(at) + 0.5) / params.dstSize;
    imageStore(dst, at, params.beforeValid != 0 ? texelFetch(before, at, 0) : vec4(uv, uv.x * uv.y, 1));
}
