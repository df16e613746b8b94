#version 460
layout(local_size_x = 8, local_size_y = 8) in;
uniform sampler2D now;
uniform sampler2D old;
layout(rgba32f) writeonly uniform image2D mixed;
layout(push_constant) uniform Params { float share; } params;

void main() {
    const ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(at, imageSize(mixed)))) return;
    imageStore(mixed, at, mix(texelFetch(old, at, 0), texelFetch(now, at, 0), params.share));
}
