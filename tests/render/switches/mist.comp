#version 460
layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba16f) uniform image2D dst;
layout(push_constant) uniform Params { float strength; } params;

void main() {
    const ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    imageStore(dst, at, mix(imageLoad(dst, at), vec4(0.75), params.strength));
}
