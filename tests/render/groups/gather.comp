#version 460
layout(local_size_x = 8, local_size_y = 8) in;
layout(push_constant) uniform Params { float power; float beforeValid; int m; } params;
uniform sampler2DArray before;
layout(r32f) writeonly uniform image2D dst;

// Half of the other round's result comes back.
void main() {
    const ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    const float other = params.beforeValid * texelFetch(before, ivec3(at, 1 - params.m), 0).x;
    imageStore(dst, at, vec4(params.power + 0.5 * other));
}
