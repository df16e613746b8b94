// The gradient sky: background, and the simple ambient light that stands in for image-based light. Units: cd/m².
// Needs frame_set.glsl.

vec3 sky_radiance(vec3 direction) {
    if (direction.y < 0.0) return mix(frame.sky_horizon, frame.sky_ground, smoothstep(0.0, 0.15, -direction.y));
    return mix(frame.sky_horizon, frame.sky_zenith, sqrt(direction.y));
}

// Irradiance / π of the sky and the ground on a surface with normal `n`. The sky half weighs the gradient by the
// cosine (∫ √y · y dy against ∫ y dy gives 4/5 zenith), then both halves meet by their share of the hemisphere.
vec3 sky_irradiance_over_pi(vec3 n) {
    const vec3 above = mix(frame.sky_horizon, frame.sky_zenith, 0.8);
    return mix(frame.sky_ground, above, 0.5 + 0.5 * n.y);
}

// Directional albedo of GGX for F0 = 1 as scale and bias. Lazarov 2013, "Getting More Physical in Call of Duty:
// Black Ops II"; replaced where a pipeline brings a lookup table.
vec2 ambient_dfg(float roughness, float nv) {
    const vec4 r = roughness * vec4(-1.0, -0.0275, -0.572, 0.022) + vec4(1.0, 0.0425, 1.04, -0.04);
    const float a004 = min(r.x * r.x, exp2(-9.28 * nv)) * r.x + r.y;
    return vec2(-1.04, 1.04) * a004 + r.zw;
}

vec3 ambient_reflection(vec3 n, vec3 v, vec3 diffuse, vec3 f0, float f90, float roughness) {
    const float nv = clamp(dot(n, v), 0.0, 1.0);
    const vec2 dfg = ambient_dfg(roughness, nv);
    const vec3 specular = f0 * dfg.x + f90 * dfg.y;
    const vec3 mirrored = mix(sky_radiance(reflect(-v, n)), sky_irradiance_over_pi(n), roughness);
    return diffuse * (1.0 - max(specular.r, max(specular.g, specular.b))) * sky_irradiance_over_pi(n) +
           specular * mirrored;
}
