// The surroundings of the scene as the eye sees them. If the scene has an environment picture, it is used; otherwise
// the sky is a gradient. For the light of the surroundings, see ambient.glsl. Units: cd/m².
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

// Returns the background that the eye sees in this direction, as the mean over one pixel.
vec3 sky_radiance(vec3 direction) {
    if (!has_environment()) return gradient_radiance(direction);
    return environment_radiance(direction, 2.0 * view.inverse_viewport.y / abs(view.projection[1][1]));
}
#endif
