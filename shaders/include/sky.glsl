// The surroundings of the scene: the background, and a simple ambient light in place of image-based lighting.
// Uses an environment picture if the scene has one, else a gradient. Units: cd/m².
#ifndef WEFT_SKY
#define WEFT_SKY
#include "frame_set.glsl"

layout(constant_id = 21) const uint environmentPictures = 1u;  // number of environment pictures in the scene: 0 or 1

bool has_environment() { return environmentPictures > 0u; }

// The position in the environment picture for a direction: -z in the middle, +y at the top.
vec2 environment_uv(vec3 direction) {
    const bool at_pole = direction.x == 0.0 && direction.z == 0.0;
    const float azimuth = at_pole ? 0.0 : atan(direction.x, -direction.z);
    return vec2(0.5 + azimuth / 6.28318530718, acos(clamp(direction.y, -1.0, 1.0)) / 3.14159265359);
}

// The environment's mean over an angle of about `spread_rad`.
vec3 environment_radiance(vec3 direction, float spread_rad) {
    const float texel_rad = 3.14159265359 / float(textureSize(environment, 0).y);
    const float lod = max(0.0, log2(spread_rad / texel_rad));
    return textureLod(environment, environment_uv(direction), lod).rgb * frame.environment_scale;
}

vec3 gradient_radiance(vec3 direction) {
    if (direction.y < 0.0) return mix(frame.sky_horizon, frame.sky_ground, smoothstep(0.0, 0.15, -direction.y));
    return mix(frame.sky_horizon, frame.sky_zenith, sqrt(direction.y));
}

// Irradiance / π of the environment from its first three orders. It is clamped at 0, because a small bright
// source can make it negative.
vec3 environment_irradiance_over_pi(vec3 n) {
    const float basis[9] = float[9](1.0, n.x, n.y, n.z, n.x * n.y, n.y * n.z, n.x * n.z, 3.0 * n.y * n.y - 1.0,
                                    n.x * n.x - n.z * n.z);
    vec3 sum = vec3(0.0);
    for (int i = 0; i < 9; ++i) sum += frame.environment_irradiance_over_pi[i].rgb * basis[i];
    return max(sum, vec3(0.0));
}

// Irradiance / π of the sky and the ground on a surface with normal `n`. In the sky half, the gradient is
// weighted by the cosine (∫ √y · y dy against ∫ y dy gives 4/5 zenith); then both halves are added by their
// share of the hemisphere.
vec3 gradient_irradiance_over_pi(vec3 n) {
    const vec3 above = mix(frame.sky_horizon, frame.sky_zenith, 0.8);
    return mix(frame.sky_ground, above, 0.5 + 0.5 * n.y);
}

// The background seen by the eye: the mean over one pixel.
vec3 sky_radiance(vec3 direction) {
    if (!has_environment()) return gradient_radiance(direction);
    return environment_radiance(direction, 2.0 * view.inverse_viewport.y / abs(view.projection[1][1]));
}

vec3 sky_irradiance_over_pi(vec3 n) {
    return has_environment() ? environment_irradiance_over_pi(n) : gradient_irradiance_over_pi(n);
}

// The reflection of a surface with this roughness. A GGX lobe is about 2 α wide; the widest lobes see the
// same as a diffuse surface.
vec3 mirrored_radiance(vec3 direction, vec3 n, float roughness) {
    if (!has_environment())
        return mix(gradient_radiance(direction), gradient_irradiance_over_pi(n), roughness);
    const float alpha = roughness * roughness;
    return mix(environment_radiance(direction, 2.0 * alpha), environment_irradiance_over_pi(n), alpha);
}

// Directional albedo of GGX for F0 = 1 as scale and bias. Lazarov 2013, "Getting More Physical in Call of
// Duty: Black Ops II"; a pipeline with a lookup table uses that instead.
vec2 ambient_dfg(float roughness, float nv) {
    const vec4 r = roughness * vec4(-1.0, -0.0275, -0.572, 0.022) + vec4(1.0, 0.0425, 1.04, -0.04);
    const float a004 = min(r.x * r.x, exp2(-9.28 * nv)) * r.x + r.y;
    return vec2(-1.04, 1.04) * a004 + r.zw;
}

// For a surface that reflects the direction `mirrored`.
vec3 ambient_reflection(vec3 n, vec3 v, vec3 mirrored, vec3 diffuse, vec3 f0, float f90, float roughness) {
    const float nv = clamp(dot(n, v), 0.0, 1.0);
    const vec2 dfg = ambient_dfg(roughness, nv);
    const vec3 specular = f0 * dfg.x + f90 * dfg.y;
    return diffuse * (1.0 - max(specular.r, max(specular.g, specular.b))) * sky_irradiance_over_pi(n) +
           specular * mirrored_radiance(mirrored, n, roughness);
}

vec3 ambient_reflection(vec3 n, vec3 v, vec3 diffuse, vec3 f0, float f90, float roughness) {
    return ambient_reflection(n, v, reflect(-v, n), diffuse, f0, f90, roughness);
}
#endif
