// Transforms the vertices of surfaces for a pass that writes only depth.
#version 460
#include "frame_set.glsl"
#include "surface_vertex.glsl"

void main() {
    const Instance instance = place_surface();
    const vec4 world = instance.object_to_world * vec4(position.xyz, 1.0);
    gl_Position = view.view_projection * world;
}
