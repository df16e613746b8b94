// Writes the directional albedo of surfaces with n·v = (x + 1) / 100 and the roughness y / 100.
#version 460
#include "dfg.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(rgba32f) writeonly uniform image2D dst;

void main() {
    const ivec2 at = ivec2(gl_GlobalInvocationID.xy), size = imageSize(dst);
    if (any(greaterThanEqual(at, size))) return;
    const float nv = float(at.x + 1) / 100.0;
    Surface s = make_surface(vec3(0.0, 1.0, 0.0), vec3(1.0), 1.0, float(at.y) / 100.0, vec3(0.0), 1.0);
    s = with_albedo(s, vec3(sqrt(1.0 - nv * nv), nv, 0.0));
    imageStore(dst, at, vec4(s.albedo, s.energy.r, 1.0));
}
