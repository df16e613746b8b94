#version 460
#include "lamp_shadow.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(std430) readonly buffer Lights { Light items[]; } lights;
layout(r32f) writeonly uniform image2D seen;

layout(push_constant) uniform Params { vec3 corner; vec3 right; vec3 down; } params;

void main() {
    const ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    const vec3 position = params.corner + float(at.x) * params.right + float(at.y) * params.down;
    const vec3 normal = normalize(cross(params.down, params.right));
    imageStore(seen, at, vec4(lamp_visibility(lights.items[0], position, normal)));
}
