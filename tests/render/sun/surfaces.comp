#version 460
#include "frame_set.glsl"
#include "octahedral.glsl"
#include "sun_shadow.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

uniform sampler2D depth;
uniform sampler2D normal;
layout(r32f) writeonly uniform image2D seen;

void main() {
    const ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(at, imageSize(seen)))) return;
    const float z = texelFetch(depth, at, 0).r;
    const vec3 position = world_position((vec2(at) + 0.5) / vec2(imageSize(seen)), max(z, 1e-6));
    const vec3 n = octahedral_decode(texelFetch(normal, at, 0).xy);
    imageStore(seen, at, vec4(z > 0.0 ? sun_visibility(position, n, distance(position, view.eye)) : 1.0));
}
