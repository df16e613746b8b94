// G-buffer geometry. One canonical vertex format: a position stream and an attribute stream.
#version 460
#include "frame_set.glsl"
#include "shared/instance.glsl"

layout(location = 0) in vec4 position;
layout(location = 1) in vec4 normal;
layout(location = 2) in vec4 tangent;
layout(location = 3) in vec2 uv;

layout(set = 3, binding = 0, std430) readonly buffer Instances { Instance instances[]; };

layout(location = 0) out vec3 world_normal;
layout(location = 1) out vec4 world_tangent;
layout(location = 2) out vec2 surface_uv;
layout(location = 3) out vec4 clip_now;
layout(location = 4) out vec4 clip_before;

void main() {
    const Instance instance = instances[gl_InstanceIndex];
    const vec4 local = vec4(position.xyz, 1.0);
    clip_now = view.view_projection * (instance.object_to_world * local);
    clip_before = view.prev_view_projection * (instance.prev_object_to_world * local);
    world_normal = mat3(instance.normal_to_world) * normal.xyz;
    world_tangent = vec4(mat3(instance.object_to_world) * tangent.xyz, tangent.w);
    surface_uv = uv;
    gl_Position = clip_now;
}
