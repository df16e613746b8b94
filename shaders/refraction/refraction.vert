// Transforms the vertices of refractive surfaces.
#version 460
#include "frame_set.glsl"
#include "surface_vertex.glsl"

layout(location = 5) out vec3 world_point;

void main() {
    const Instance instance = place_surface();
    const vec4 world = instance.object_to_world * vec4(position.xyz, 1.0);
    world_point = world.xyz;
    gl_Position = view.view_projection * world;
}
