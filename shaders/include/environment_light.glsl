// The light of the surroundings from all directions, without the objects of the scene. Units: cd/m². Ports, all
// optional: `environmentCube`, `environmentIrradiance` and `environmentSh` of graphs/modules/environment.json. Without
// `environmentCube`, mirrored light comes from the blurred picture or the gradient sky. Without `environmentIrradiance`,
// diffuse light comes from the harmonics in `environmentSh` or, without `environmentSh` too, from the harmonics in
// `frame`.
#ifndef WEFT_ENVIRONMENT_LIGHT
#define WEFT_ENVIRONMENT_LIGHT
#include "environment_cube.glsl"
#include "frame_set.glsl"
#include "sky.glsl"

layout(constant_id = 23) const bool HAS_environmentCube = false;
layout(constant_id = 24) const bool HAS_environmentSh = false;
layout(constant_id = 32) const bool HAS_environmentIrradiance = false;
uniform samplerCube environmentCube;  // Radiance / frame.environment_unit; each mip is filtered for a roughness.
uniform samplerCube environmentIrradiance;  // Irradiance / π / frame.environment_unit for each normal.
layout(std430) readonly buffer EnvironmentSh { vec4 items[]; } environmentSh;  // 4 or 9 coefficients, in cd/m².

// Returns irradiance / π of the environment picture, from its first three orders of spherical harmonics. The sum can be
// negative for a small bright source, so negative values become 0.
vec3 picture_irradiance_over_pi(vec3 n) {
    const float basis[9] = harmonic_basis(n);
    vec3 sum = vec3(0.0);
    for (int i = 0; i < 9; ++i) sum += frame.environment_irradiance_over_pi[i].rgb * basis[i];
    return max(sum, vec3(0.0));
}

// Returns irradiance / π of the gradient sky and the ground on a surface with normal `n`. The colour of the sky goes
// from horizon to zenith with the weight √y, where y is the sine of the elevation. So the irradiance of the whole sky
// is 4/5 zenith and 1/5 horizon (∫ √y · y dy = 4/5 ∫ y dy for y from 0 to 1). Sky and ground are mixed by their shares
// of the hemisphere.
vec3 gradient_irradiance_over_pi(vec3 n) {
    const vec3 above = mix(frame.sky_horizon, frame.sky_zenith, 0.8);
    return mix(frame.sky_ground, above, 0.5 + 0.5 * n.y);
}

// Returns irradiance / π of the surroundings on a surface with the normal `n`.
vec3 sky_irradiance_over_pi(vec3 n) {
    if (HAS_environmentIrradiance) return textureLod(environmentIrradiance, n, 0.0).rgb * frame.environment_unit;
    if (HAS_environmentSh) {
        const float basis[9] = harmonic_basis(n);
        const int terms = min(environmentSh.items.length(), 9);
        vec3 sum = vec3(0.0);
        for (int i = 0; i < terms; ++i) sum += environmentSh.items[i].rgb * basis[i];
        return max(sum, vec3(0.0));
    }
    return has_environment() ? picture_irradiance_over_pi(n) : gradient_irradiance_over_pi(n);
}

// Returns the sky's radiance in a mirrored direction, blurred for the roughness, without a filtered cube. A GGX lobe is
// about 2 α wide. At the roughness 1, the result is irradiance / π, as for a diffuse surface.
vec3 blurred_radiance(vec3 direction, vec3 n, float roughness) {
    if (!has_environment())
        return mix(gradient_radiance(direction), sky_irradiance_over_pi(n), roughness);
    const float alpha = roughness * roughness;
    return mix(environment_radiance(direction, 2.0 * alpha), sky_irradiance_over_pi(n), alpha);
}

// Returns the light that the filtered cube contains for a direction and a roughness. For the roughness 1, the result is
// irradiance / π.
vec3 filtered_radiance(vec3 direction, float roughness) {
    const float lod = lod_of_roughness(roughness);
    const vec3 filtered = textureLod(environmentCube, direction, min(lod, kLastFiltered)).rgb * frame.environment_unit;
    if (lod <= kLastFiltered) return filtered;
    return mix(filtered, sky_irradiance_over_pi(direction), min(lod - kLastFiltered, 1.0));
}
#endif
