// Adds up the sums that harmonics_parts.comp has written for the parts of the cube, and writes the coefficients of
// irradiance / π in cd/m².
//
// If there is a small bright source, the sum of harmonics of three orders can be negative in directions that face away
// from the source. In this case, the orders 1 and 2 are multiplied by a window, that is by factors below 1. The window
// reduces the orders only as much as needed: P.-P. Sloan, "Deringing Spherical Harmonics", 2017. In 128 directions, the
// sum must be at least kLeastShare times the light that the darkest of these directions receives. This light is
// computed without harmonics.
#version 460
#include "cube_texels.glsl"
#include "environment_cube.glsl"
#include "frame_set.glsl"

layout(local_size_x = 128) in;

readonly buffer Parts { vec4 items[]; } parts;
uniform sampler2DArray raw;  // The mip with 8 × 8 texels per face.
layout(std430) writeonly buffer EnvironmentSh { vec4 items[]; } environmentSh;

const float kPi = 3.14159265;
const uint kSize = 8u, kBeams = 6u * kSize * kSize;
const float kLeastShare = 0.7;  // The same value as in framework/scene/pictures/environment.cpp.
// The sum of the harmonics may be smaller than the required light by this share of the mean light. So the sum can still
// be slightly negative. The shaders that read the coefficients replace negative sums by 0.
const float kTolerance = 0.01;
const int kMostSteps = 21;

shared vec3 coefficients[9];
shared vec3 beams[kBeams];  // Direction of the light of each texel of `raw`; `fluxes` has its flux.
shared vec3 fluxes[kBeams];
shared uint least_bits[3];
shared uint failed_steps;  // Bit i is 1 if window(i) does not reduce the orders enough in some direction.

vec3 side(uint i) {
    const float polar = kPi * (float(i / 16u) + 0.5) / 8.0, azimuth = kPi * float(i % 16u) / 8.0;
    return vec3(sin(polar) * sin(azimuth), cos(polar), -sin(polar) * cos(azimuth));
}

// Returns the factors for the orders 1 and 2. A larger number of steps gives smaller factors; with 0 steps, both
// factors are 1.
vec2 window(int steps) {
    if (steps == 0) return vec2(1.0);
    const float strength = 0.002 * pow(1.5, float(steps - 1));
    return vec2(1.0 / (1.0 + 4.0 * strength), 1.0 / (1.0 + 36.0 * strength));
}

void find_beams() {
    for (uint i = gl_LocalInvocationIndex; i < kBeams; i += gl_WorkGroupSize.x) {
        const uvec3 at = uvec3(i % kSize, i / kSize % kSize, i / (kSize * kSize));
        const vec2 middle = face_position(at.xy, float(kSize));
        beams[i] = normalize(face_direction(at.z, middle));
        fluxes[i] = texelFetch(raw, ivec3(at), 0).rgb * texel_solid_angle(middle, float(kSize));
    }
}

void main() {
    const uint thread = gl_LocalInvocationIndex;
    if (thread < 3u) least_bits[thread] = floatBitsToUint(1e30);
    if (thread == 0u) failed_steps = 0u;
    if (thread < 9u) {
        vec3 sum = vec3(0.0);
        for (uint part = 0u; part < uint(parts.items.length()) / 9u; ++part) sum += parts.items[part * 9u + thread].rgb;
        coefficients[thread] = sum * kIrradianceFactors[thread];
    }
    find_beams();
    barrier();
    const vec3 direction = side(thread);
    vec3 received = vec3(0.0);
    for (uint i = 0u; i < kBeams; ++i) received += fluxes[i] * max(dot(direction, beams[i]), 0.0);
    for (int c = 0; c < 3; ++c) atomicMin(least_bits[c], floatBitsToUint(received[c] * (kLeastShare / kPi)));
    barrier();
    const vec3 least = uintBitsToFloat(uvec3(least_bits[0], least_bits[1], least_bits[2]));
    const float basis[9] = harmonic_basis(direction);
    vec3 orders[3] = vec3[3](coefficients[0], vec3(0.0), vec3(0.0));
    for (int i = 1; i < 9; ++i) orders[i < 4 ? 1 : 2] += coefficients[i] * basis[i];
    const vec3 enough = least - kTolerance * coefficients[0];
    uint failed = 0u;
    for (int steps = 0; steps < kMostSteps; ++steps) {
        const vec2 factors = window(steps);
        if (any(lessThan(orders[0] + factors.x * orders[1] + factors.y * orders[2], enough))) failed |= 1u << steps;
    }
    atomicOr(failed_steps, failed);
    barrier();
    if (thread >= uint(environmentSh.items.length())) return;
    const vec2 factors = window(findLSB(~failed_steps));
    const float factor = thread == 0u ? 1.0 : (thread < 4u ? factors.x : factors.y);
    environmentSh.items[thread] = vec4(coefficients[thread] * (factor * frame.environment_unit), 0.0);
}
