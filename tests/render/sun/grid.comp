#version 460
#include "frame_set.glsl"
#include "sun_shadow.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(r32f) writeonly uniform image2D seen;

layout(push_constant) uniform Params { vec3 corner; vec3 right; vec3 down; } params;

void main() {
    const ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    const vec3 position = params.corner + float(at.x) * params.right + float(at.y) * params.down;
    const vec3 normal = normalize(cross(params.down, params.right));
    imageStore(seen, at, vec4(sun_visibility(position, normal, distance(position, view.eye))));
}
