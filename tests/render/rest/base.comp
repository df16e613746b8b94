#version 460
layout(local_size_x = 8, local_size_y = 8) in;
layout(push_constant) uniform Params { float power; } params;
layout(r32f) writeonly uniform image2D dst;

void main() {
    const vec2 uv = (vec2(gl_GlobalInvocationID.xy) + 0.5) / vec2(imageSize(dst));
    imageStore(dst, ivec2(gl_GlobalInvocationID.xy), vec4(pow(uv.x, params.power)));
}
