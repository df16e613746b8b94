// The function place_vertex() of vertex shaders for forward shading. Its result world_point is for forward_surface.glsl.
#ifndef WEFT_FORWARD_VERTEX
#define WEFT_FORWARD_VERTEX
#include "frame_set.glsl"
#include "surface_vertex.glsl"

layout(location = 5) out vec3 world_point;

void place_vertex() {
    const Instance instance = place_surface();
    const vec4 world = instance.object_to_world * vec4(position.xyz, 1.0);
    world_point = world.xyz;
    gl_Position = view.view_projection * world;
}
#endif
