#version 460
layout(local_size_x = 8, local_size_y = 8) in;
layout(push_constant) uniform Params { float value; } params;
layout(rgba16f) readonly uniform image2D a;
uniform sampler2DArray w;
layout(rgba16f) writeonly uniform image2D dst;

void main() {
    const ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    imageStore(dst, at, vec4(params.value + 0.125 + 0.5 * imageLoad(a, at).x + 0.25 * (texelFetch(w, ivec3(at, 0), 0).x + texelFetch(w, ivec3(at, 1), 0).x), vec2(at) / 64.0, 1));
}
