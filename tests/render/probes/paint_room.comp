// Paints what a reflection probe at (0, 2, 1) sees in a closed room: x and z from −5 to 5, y from 0 to 6. The radiance of
// a wall is its number, +x 1, −x 2, +y 3, −y 4, +z 5, −z 6, plus (x + 2 y + 3 z) / 100.
#version 460
#include "cube_texels.glsl"
#include "shared/probe_grid.glsl"
#include "shared/probe_sh.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(rgba16f) writeonly uniform image2DArray reflectionCubes;
layout(std430) writeonly buffer ReflectionSh { vec4 items[]; } reflectionSh;

const vec3 kProbe = vec3(0.0, 2.0, 1.0), kLow = vec3(-5.0, 0.0, -5.0), kHigh = vec3(5.0, 6.0, 5.0);

void main() {
    const uvec3 at = gl_GlobalInvocationID;
    if (any(greaterThanEqual(ivec3(at), imageSize(reflectionCubes)))) return;
    const vec3 direction = normalize(face_direction(at.z, face_position(at.xy, float(imageSize(reflectionCubes).x))));
    const vec3 ends = (mix(kLow, kHigh, greaterThan(direction, vec3(0.0))) - kProbe) / direction;
    const float distance_m = min(ends.x, min(ends.y, ends.z));
    const int axis = ends.x == distance_m ? 0 : (ends.y == distance_m ? 1 : 2);
    const float wall = float(2 * axis + (direction[axis] > 0.0 ? 1 : 2));
    const float light = wall + dot(kProbe + direction * distance_m, vec3(0.01, 0.02, 0.03));
    imageStore(reflectionCubes, ivec3(at), vec4(vec3(light * kProbeRadianceScale), 1.0 / distance_m));
    if (at == uvec3(0)) {
        for (uint i = 0u; i < kProbeShStride; ++i) reflectionSh.items[i] = vec4(vec3(0.0), 1.0);
    }
}
