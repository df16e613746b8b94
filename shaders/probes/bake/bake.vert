// Transforms surfaces to a face of a probe.
#version 460
#include "frame_set.glsl"
#include "surface_vertex.glsl"

layout(location = 5) out vec3 from_probe;  // The vector from the probe to the vertex, in world space.

void main() {
    const Instance instance = place_surface();
    const vec4 world = instance.object_to_world * vec4(position.xyz, 1.0);
    from_probe = world.xyz - view.eye;
    gl_Position = view.view_projection * world;
}
