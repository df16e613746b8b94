// Writes one mip of the filtered cube: the light that a surface with the roughness of the mip mirrors if it is seen
// from straight above (GGX with N = V). Each texel is a mean of a few samples of the raw cube. A sample reads the mip whose
// texels have about the solid angle for which the sample stands: Křivánek and Colbert 2008, "Real-time Shading with
// Filtered Importance Sampling". The half vectors of the samples lie on a spiral with the golden angle. The spiral is
// turned by a different angle for each texel.
#version 460
#include "cube_texels.glsl"
#include "environment_cube.glsl"
#include "half_float.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

uniform samplerCube raw;
layout(rgba16f) writeonly uniform image2DArray dst;
layout(push_constant) uniform Params { int i; int environmentSamples; float environmentLodBias; } params;

// A picture can have small bright sources, so it needs more samples than the gradient sky.
layout(constant_id = 21) const uint environmentPictures = 1u;

const int kMostSamples = 1024;
const float kPi = 3.14159265;

shared vec4 samples[kMostSamples];  // xyz: direction of the light, z along the normal; w: level of detail.

// The samples read mips, and this widens the lobe. To compensate, the half vectors are distributed for a roughness that
// is smaller by these numbers (index: mip). The numbers were chosen so that, with 32 samples and the bias −0.5, the
// orders 1 and 2 of spherical harmonics have errors of less than 0.5 %. The widening is inversely proportional to the
// number of samples.
const float kNarrower[6] = float[6](0.0, 0.0, 0.012, 0.007, 0.0045, 0.010);

int basic_count() { return params.environmentSamples * (environmentPictures > 0u ? 4 : 1); }

float sampled_roughness() {
    return roughness_of_mip(params.i) - kNarrower[params.i] * min(32.0 / float(basic_count()), 1.0);
}

// The narrow lobe of mip 1 needs the fewest samples. The widest lobes get the most samples, because their mips are
// small and cost little.
int sample_count() {
    const int quarters = params.i == 1 ? 1 : (params.i < 4 ? 8 : 16);
    return clamp(basic_count() * quarters / 4, 1, kMostSamples);
}

void make_sample(int k, int count) {
    const float alpha = sampled_roughness() * sampled_roughness(), a2 = alpha * alpha;
    const float u = (float(k) + 0.5) / float(count);
    const float cos2 = (1.0 - u) / (1.0 + (a2 - 1.0) * u);
    const float sine = 2.0 * sqrt(cos2 * (1.0 - cos2)), cosine = 2.0 * cos2 - 1.0;
    const float turn = 2.0 * kPi * fract(float(k) * 0.618034);
    const float d = (a2 - 1.0) * cos2 + 1.0;
    const float pdf = a2 / (4.0 * kPi * d * d);
    const float size = float(textureSize(raw, 0).x);
    const float texels = 6.0 * size * size / (4.0 * kPi * float(count) * pdf);
    const float lod = max(0.5 * log2(texels) + params.environmentLodBias, 0.0);
    samples[k] = vec4(sine * cos(turn), sine * sin(turn), cosine, lod);
}

// Returns a number from 0 to 1 that looks random: Jarzynski and Olano 2020, "Hash Functions for GPU Rendering".
float hash(uint x) {
    const uint state = x * 747796405u + 2891336453u;
    const uint word = ((state >> ((state >> 28) + 4u)) ^ state) * 277803737u;
    return float(((word >> 22) ^ word) >> 8) * (1.0 / 16777216.0);
}

void main() {
    const int count = sample_count();
    for (int k = int(gl_LocalInvocationIndex); k < count; k += 64) make_sample(k, count);
    barrier();
    const uvec3 at = gl_GlobalInvocationID;
    const ivec3 size = imageSize(dst);
    if (any(greaterThanEqual(ivec3(at), size))) return;
    const vec3 n = normalize(face_direction(at.z, face_position(at.xy, float(size.x))));
    const vec3 other = abs(n.z) < 0.9 ? vec3(0.0, 0.0, 1.0) : vec3(1.0, 0.0, 0.0);
    const vec3 x = normalize(cross(other, n)), y = cross(n, x);
    const float turn = 2.0 * kPi * hash((at.z * uint(size.y) + at.y) * uint(size.x) + at.x);
    const vec3 tangent = x * cos(turn) + y * sin(turn), bitangent = cross(n, tangent);
    vec4 sum = vec4(0.0);
    for (int k = 0; k < count; ++k) {
        const vec4 light = samples[k];
        if (light.z <= 0.0) continue;
        const vec3 direction = tangent * light.x + bitangent * light.y + n * light.z;
        sum += light.z * vec4(textureLod(raw, direction, light.w).rgb, 1.0);
    }
    imageStore(dst, ivec3(at), vec4(nearest_half(sum.rgb / sum.w), 1.0));
}
