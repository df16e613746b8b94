#version 460
#include "frame_set.glsl"
#include "shared/instance.glsl"

layout(location = 0) in vec4 position;
layout(location = 1) in vec4 normal;
layout(location = 2) in vec2 uv;

layout(set = 3, binding = 0, std430) readonly buffer Instances { Instance instances[]; };

layout(location = 0) out vec3 world_normal;
layout(location = 1) out vec2 surface_uv;

void main() {
    const Instance instance = instances[gl_InstanceIndex];
    world_normal = mat3(instance.normal_to_world) * normal.xyz;
    surface_uv = uv;
    gl_Position = view.view_projection * (instance.object_to_world * vec4(position.xyz, 1.0));
}
