// Writes the light of the surroundings that each texel of a light probe receives where the probe sees no surface: the
// mean of the environment cube over the texel. The faces of both cubes have the same orientation.
#version 460
#include "cube_texels.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

uniform samplerCube cube;
layout(rgba32f) writeonly uniform image2DArray sky;

void main() {
    const uvec3 at = gl_GlobalInvocationID;
    const ivec3 size = imageSize(sky);
    if (any(greaterThanEqual(ivec3(at), size))) return;
    // Each sample lies at the corner between four texels of the cube, so the linear filter returns their mean.
    const int side = max(textureSize(cube, 0).x / (2 * size.x), 1);
    const vec2 corner = face_position(at.xy, float(size.x)) - 1.0 / float(size.x);
    vec4 sum = vec4(0.0);
    for (int i = 0; i < side * side; ++i) {
        const vec2 place = corner + (vec2(i % side, i / side) + 0.5) * (2.0 / float(side * size.x));
        const float inverse = inversesqrt(1.0 + dot(place, place));
        const vec3 light = textureLod(cube, face_direction(at.z, place), 0.0).rgb;
        sum += inverse * inverse * inverse * vec4(light, 1.0);
    }
    imageStore(sky, ivec3(at), vec4(sum.rgb / sum.w, 1.0));
}
