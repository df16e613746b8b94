#version 460
#include "frame_set.glsl"
#include "shared/instance.glsl"
#include "shared/material.glsl"
layout(location = 0) in vec4 position;
readonly buffer Instances { Instance items[]; } instances;
readonly buffer Materials { Material items[]; } materials;
layout(location = 0) flat out vec4 color;
void main() {
    const Instance instance = instances.items[gl_InstanceIndex];
    gl_Position = view.view_projection * (instance.object_to_world * vec4(position.xyz, 1.0));
    color = materials.items[instance.material].base_color;
}
