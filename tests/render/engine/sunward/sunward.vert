#version 460
#include "frame_set.glsl"
#include "shared/instance.glsl"
layout(set = 3, binding = 0, std430) readonly buffer Instances { Instance items[]; } instances;
layout(location = 0) in vec4 position;

void main() {
    gl_Position = view.view_projection * (instances.items[gl_InstanceIndex].object_to_world * vec4(position.xyz, 1));
}
