#version 460
layout(local_size_x = 8, local_size_y = 8) in;
layout(push_constant) uniform Params { uint beforeValid; } params;
uniform sampler2D before;
layout(rgba32f) writeonly uniform image2D dst;

// Writes 1 if the history contains 1 or is not valid yet, otherwise 0.25. The output is the history of the
// next frame. So if the content of the history is lost once, the output stays 0.25.
void main() {
    const ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    const vec4 past = texelFetch(before, at, 0);
    imageStore(dst, at, params.beforeValid == 0 ? vec4(1) : past == vec4(1) ? vec4(1) : vec4(0.25));
}
