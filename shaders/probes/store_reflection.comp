// Stores the light that a reflection probe sees, as half floats: in mip 0 of its cube, together with the inverse
// distance of each texel, and in a second cube without distances. The mips are filtered from the second cube.
#version 460
#include "half_float.glsl"
#include "shared/probe_grid.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

uniform sampler2DArray lit;                       // cd/m²
uniform sampler2DArray reflectionDistance;        // As probeDistance.
layout(rgba16f) writeonly uniform image2DArray raw, cube;

const float kMaxStored = 65000.0;

void main() {
    const ivec3 at = ivec3(gl_GlobalInvocationID);
    if (any(greaterThanEqual(at, imageSize(cube)))) return;
    const vec3 light = nearest_half(min(texelFetch(lit, at, 0).rgb * kProbeRadianceScale, vec3(kMaxStored)));
    const float distance_m = abs(texelFetch(reflectionDistance, at, 0).r);
    imageStore(raw, at, vec4(light, 1.0));
    imageStore(cube, at, vec4(light, nearest_half(vec3(distance_m > 0.0 ? 1.0 / distance_m : 0.0)).x));
}
