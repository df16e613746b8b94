#version 460
layout(local_size_x = 8, local_size_y = 8) in;
layout(constant_id = 0) const bool HAS_b = false;
uniform sampler2D a, b;
layout(rgba16f) writeonly uniform image2D dst;
layout(push_constant) uniform Params { vec2 bSize; } params;

void main() {
    const ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    vec4 value = 0.5 * texelFetch(a, at, 0) + vec4(params.bSize / 512.0, 0, 0);
    if (HAS_b) value += 0.25 * texelFetch(b, at, 0);
    imageStore(dst, at, value);
}
