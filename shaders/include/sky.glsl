// The surroundings of the scene: the background, and a simple ambient light instead of image-based lighting. If the
// scene has an environment picture, it is used; otherwise the sky is a gradient. Units: cd/m².
#ifndef WEFT_SKY
#define WEFT_SKY
#include "frame_set.glsl"

layout(constant_id = 21) const uint environmentPictures = 1u;  // Number of environment pictures: 0 or 1.

bool has_environment() { return environmentPictures > 0u; }

// Returns the position in the environment picture for a direction: -z is in the middle, +y is at the top.
vec2 environment_uv(vec3 direction) {
    const bool at_pole = direction.x == 0.0 && direction.z == 0.0;
    const float azimuth = at_pole ? 0.0 : atan(direction.x, -direction.z);
    return vec2(0.5 + azimuth / 6.28318530718, acos(clamp(direction.y, -1.0, 1.0)) / 3.14159265359);
}

// Returns the mean radiance of the environment picture over an angle of about `spread_rad`.
vec3 environment_radiance(vec3 direction, float spread_rad) {
    const float texel_rad = 3.14159265359 / float(textureSize(environment, 0).y);
    const float lod = max(0.0, log2(spread_rad / texel_rad));
    return textureLod(environment, environment_uv(direction), lod).rgb * frame.environment_scale;
}

vec3 gradient_radiance(vec3 direction) {
    if (direction.y < 0.0) return mix(frame.sky_horizon, frame.sky_ground, smoothstep(0.0, 0.15, -direction.y));
    return mix(frame.sky_horizon, frame.sky_zenith, sqrt(direction.y));
}

// Returns irradiance / π of the environment, from its first three orders of spherical harmonics. The sum can be
// negative for a small bright source, so negative values become 0.
vec3 environment_irradiance_over_pi(vec3 n) {
    const float basis[9] = float[9](1.0, n.x, n.y, n.z, n.x * n.y, n.y * n.z, n.x * n.z, 3.0 * n.y * n.y - 1.0,
                                    n.x * n.x - n.z * n.z);
    vec3 sum = vec3(0.0);
    for (int i = 0; i < 9; ++i) sum += frame.environment_irradiance_over_pi[i].rgb * basis[i];
    return max(sum, vec3(0.0));
}

// Returns irradiance / π of the gradient sky and the ground on a surface with normal `n`. The irradiance of the whole
// sky, weighted by the cosine, is 4/5 zenith and 1/5 horizon (∫ √y · y dy = 4/5 ∫ y dy). Sky and ground are mixed by
// their shares of the hemisphere.
vec3 gradient_irradiance_over_pi(vec3 n) {
    const vec3 above = mix(frame.sky_horizon, frame.sky_zenith, 0.8);
    return mix(frame.sky_ground, above, 0.5 + 0.5 * n.y);
}

// Returns the background that the eye sees in this direction, as the mean over one pixel.
vec3 sky_radiance(vec3 direction) {
    if (!has_environment()) return gradient_radiance(direction);
    return environment_radiance(direction, 2.0 * view.inverse_viewport.y / abs(view.projection[1][1]));
}

vec3 sky_irradiance_over_pi(vec3 n) {
    return has_environment() ? environment_irradiance_over_pi(n) : gradient_irradiance_over_pi(n);
}

// Returns the sky's radiance in a mirrored direction, blurred for the roughness. A GGX lobe is about 2 α wide. At the
// largest roughness, the result is that of a diffuse surface.
vec3 mirrored_radiance(vec3 direction, vec3 n, float roughness) {
    if (!has_environment())
        return mix(gradient_radiance(direction), gradient_irradiance_over_pi(n), roughness);
    const float alpha = roughness * roughness;
    return mix(environment_radiance(direction, 2.0 * alpha), environment_irradiance_over_pi(n), alpha);
}

// Returns the factors of F0 (x) and F90 (y) whose sum is the directional albedo of GGX, from a fitted formula. Source:
// Lazarov 2013, "Getting More Physical in Call of Duty: Black Ops II".
vec2 ambient_dfg(float roughness, float nv) {
    const vec4 r = roughness * vec4(-1.0, -0.0275, -0.572, 0.022) + vec4(1.0, 0.0425, 1.04, -0.04);
    const float a004 = min(r.x * r.x, exp2(-9.28 * nv)) * r.x + r.y;
    return vec2(-1.04, 1.04) * a004 + r.zw;
}

// Returns the reflection of the sky by a surface. `mirrored` is the direction in which the surface mirrors the sky.
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
