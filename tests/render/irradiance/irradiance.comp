// Measures irradiance with light_reflection() of the shader library: a white diffuse surface reflects irradiance / π.
// Also measures the highlights on a white metal. Row y of the outputs is for light y, and column x is for one of 8 × 8
// points of the plane y = 0. The channels of `highlight` are for four roughnesses of the metal.
#version 460
#include "brdf.glsl"
#include "frame_set.glsl"
#include "lights.glsl"
#include "light_reflection.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(std430) readonly buffer Lights { Light items[]; } lights;
layout(rgba32f) writeonly uniform image2D irradiance;
layout(rgba32f) writeonly uniform image2D highlight;

const vec3 kEye = vec3(0.5, 2.5, 6.0);

void main() {
    const ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(at, imageSize(irradiance)))) return;
    vec3 radiance = vec3(0.0);
    vec4 mirrored = vec4(0.0);
    if (at.y < int(frame.light_count)) {
        const vec3 position = vec3(float(at.x % 8) - 3.5, 0.0, float(at.x / 8) - 3.5);
        const vec3 up = vec3(0.0, 1.0, 0.0);
        const Surface matt = make_surface(up, vec3(1.0), 0.0, 1.0, vec3(0.0), 0.0);
        radiance = light_reflection(matt, up, position, lights.items[at.y]);
        for (int i = 0; i < 4; ++i) {
            const float roughness = float[4](0.1, 0.3, 0.6, 1.0)[i];
            const Surface metal = make_surface(up, vec3(1.0), 1.0, roughness, vec3(0.0), 1.0);
            mirrored[i] = light_reflection(metal, normalize(kEye - position), position, lights.items[at.y]).r;
        }
    }
    imageStore(irradiance, at, vec4(radiance * kPi, 1.0));
    imageStore(highlight, at, mirrored);
}
