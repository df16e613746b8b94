// Transforms the vertices of transparent surfaces, for the reflections.
#version 460
#include "frame_set.glsl"
#include "surface_vertex.glsl"

void main() {
    const Instance instance = place_surface();
    gl_Position = view.view_projection * (instance.object_to_world * vec4(position.xyz, 1.0));
}
