// Writes the radiance of the surroundings to mip 0 of two cubes. The surroundings are the environment picture for
// lighting or, without a picture, the gradient sky. Texels are divided by frame.environment_unit, so that half floats
// neither overflow nor lose precision.
#version 460
#include "cube_texels.glsl"
#include "frame_set.glsl"
#include "half_float.glsl"
#include "sky.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(rgba16f) writeonly uniform image2DArray raw;
layout(rgba16f) writeonly uniform image2DArray cube;

const float kMaxStored = 65000.0;

vec3 source_radiance(vec3 direction, float size) {
    if (!has_environment()) return gradient_radiance(direction);
    // main() takes 2 × 2 samples for a texel of the cube. Where a sample stands for several texels of the picture, the
    // sample reads a mip of the picture.
    const float lod = max(0.0, log2(float(textureSize(environment_light, 0).y) / (3.14159265 * size)));
    return textureLod(environment_light, environment_uv(direction), lod).rgb * frame.environment_light_scale;
}

void main() {
    const uvec3 at = gl_GlobalInvocationID;
    const ivec3 size = imageSize(cube);
    if (any(greaterThanEqual(ivec3(at), size))) return;
    const vec2 middle = face_position(at.xy, float(size.x));
    vec3 sum = vec3(0.0);
    for (int i = 0; i < 4; ++i) {
        const vec2 offset = vec2((i & 1) * 2 - 1, (i >> 1) * 2 - 1) * (0.5 / float(size.x));
        sum += source_radiance(normalize(face_direction(at.z, middle + offset)), float(size.x));
    }
    const vec3 light = min(sum * (0.25 / frame.environment_unit), vec3(kMaxStored));
    const vec4 texel = vec4(nearest_half(light), 1.0);
    imageStore(raw, ivec3(at), texel);
    imageStore(cube, ivec3(at), texel);
}
