// Measures the light of the probes on a level square: irradiance / π, and the validity in w.
#version 460
#include "probes.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(rgba32f) writeonly uniform image2D measured;

layout(push_constant) uniform Params { float side, middleX, height, middleZ, facing; } params;

void main() {
    const ivec2 at = ivec2(gl_GlobalInvocationID.xy), size = imageSize(measured);
    if (any(greaterThanEqual(at, size))) return;
    const vec2 place = ((vec2(at) + 0.5) / vec2(size) - 0.5) * params.side;
    const vec3 n = vec3(0.0, params.facing, 0.0);
    imageStore(measured, at, probe_irradiance_over_pi(vec3(params.middleX + place.x, params.height, params.middleZ + place.y), n, n));
}
