// Looks up the ambient light in each direction of a spiral around the sphere.
#version 460
#include "ambient.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(rgba32f) writeonly uniform image2D mirrored;
layout(rgba32f) writeonly uniform image2D diffuse;

void main() {
    const ivec2 at = ivec2(gl_GlobalInvocationID.xy), size = imageSize(mirrored);
    if (any(greaterThanEqual(at, size))) return;
    const float y = 1.0 - (2.0 * float(at.x) + 1.0) / float(size.x);
    const float azimuth = 2.39996323 * float(at.x);
    const vec3 n = vec3(sqrt(1.0 - y * y) * vec2(cos(azimuth), sin(azimuth)), y).xzy;
    imageStore(mirrored, at, vec4(mirrored_radiance(n, n, 0.1 * float(at.y + 1)), 1.0));
    if (at.y == 0) imageStore(diffuse, at, vec4(sky_irradiance_over_pi(n), 1.0));
}
