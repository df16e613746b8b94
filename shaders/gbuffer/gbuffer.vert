// Transforms the vertices of surfaces for the G-buffer, with their positions in this frame and in the previous frame.
#version 460
#include "frame_set.glsl"
#include "surface_vertex.glsl"

layout(location = 5) out vec4 clip_now;
layout(location = 6) out vec4 clip_before;

void main() {
    const Instance instance = place_surface();
    const vec4 local = vec4(position.xyz, 1.0);
    const vec4 world = instance.object_to_world * local;
    clip_now = view.steady_view_projection * world;
    clip_before = view.prev_view_projection * (instance.prev_object_to_world * local);
    gl_Position = view.view_projection * world;
}
