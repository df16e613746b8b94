// Looks up the mirrored light for 3 angles to the eye (n·v) and 4 roughnesses, and the diffuse light, for each normal of
// a spiral around the sphere.
#version 460
#include "ambient.glsl"

layout(local_size_x = 8, local_size_y = 4) in;

layout(rgba32f) writeonly uniform image2D slanted;
layout(rgba32f) writeonly uniform image2D irradiance;

const float kRoughnesses[4] = float[4](0.25, 0.4, 0.6, 0.8);
const float kCosines[3] = float[3](0.9, 0.6, 0.35);

void main() {
    const ivec2 at = ivec2(gl_GlobalInvocationID.xy), size = imageSize(slanted);
    if (any(greaterThanEqual(at, size))) return;
    const float y = 1.0 - (2.0 * float(at.x) + 1.0) / float(size.x);
    const float azimuth = 2.39996323 * float(at.x);
    const vec3 n = vec3(sqrt(1.0 - y * y) * vec2(cos(azimuth), sin(azimuth)), y).xzy;
    const vec3 across = normalize(cross(n, abs(n.y) < 0.9 ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0)));
    const float nv = kCosines[at.y % 3];
    const vec3 v = n * nv + across * sqrt(1.0 - nv * nv);
    imageStore(slanted, at, vec4(mirrored_radiance(reflect(-v, n), n, kRoughnesses[at.y / 3]), 1.0));
    if (at.y == 0) imageStore(irradiance, at, vec4(sky_irradiance_over_pi(n), 1.0));
}
