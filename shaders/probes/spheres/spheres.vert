// Places a square around each probe, facing the camera, in which the fragment shader draws a sphere.
#version 460
#include "frame_set.glsl"
#include "shared/probe_grid.glsl"

layout(std430) readonly buffer Points { ProbePoint items[]; } probePoints;

layout(location = 0) out vec3 on_square;  // Position in world space.
layout(location = 1) flat out vec4 sphere;  // xyz: centre, w: radius in m.
layout(location = 2) flat out uint probe;

void main() {
    const ProbePoint point = probePoints.items[gl_InstanceIndex];
    const float radius_m = clamp(0.08 * point.spacing_m, 0.03, 0.3);
    const vec2 corners[6] =
        vec2[](vec2(-1.0), vec2(1.0, -1.0), vec2(-1.0, 1.0), vec2(-1.0, 1.0), vec2(1.0, -1.0), vec2(1.0));
    // Seen from nearby, a sphere covers more of the square than its cross-section does: from a distance of 2 radii, a
    // disc of 1.15 radii. So the square is larger than the sphere.
    const vec2 at = corners[gl_VertexIndex] * radius_m * 1.25;
    const mat3 to_world = transpose(mat3(view.view));
    on_square = point.position + to_world * vec3(at, 0.0);
    sphere = vec4(point.position, radius_m);
    probe = uint(gl_InstanceIndex);
    gl_Position = view.view_projection * vec4(on_square, 1.0);
}
