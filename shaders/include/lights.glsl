// Computes the light that arrives at a point. Units: lx on a plane that faces the light. Falloff with distance and with
// the angle to a spot's axis: KHR_lights_punctual.
#ifndef WEFT_LIGHTS
#define WEFT_LIGHTS
#include "shared/light.glsl"

// Returns the cosine of the angle between the axis of a spot and the edge of its cone.
float cone_edge(Light light) { return -light.cone_offset / light.cone_scale; }

struct Incident {
    vec3 direction;    // Direction from the point to the light.
    vec3 irradiance;
};

// Returns the angular radius of the disc of a directional light in radians; 0 if the light has no disc.
float disc_radius_rad(Light light) { return light.type == kLightDirectional ? light.cone_scale : 0.0; }

float distance_window(float distance2, float range_m) {
    if (range_m <= 0.0) return 1.0;
    const float ratio2 = distance2 / (range_m * range_m);
    return clamp(1.0 - ratio2 * ratio2, 0.0, 1.0);
}

Incident light_at(Light light, vec3 position) {
    if (light.type == kLightDirectional) return Incident(-light.direction, light.intensity);
    const vec3 to_light = light.position - position;
    const float distance2 = max(dot(to_light, to_light), 1e-8);
    const vec3 direction = to_light * inversesqrt(distance2);
    float falloff = distance_window(distance2, light.range_m) / distance2;
    if (light.type == kLightSpot) {
        const float cone = clamp(dot(light.direction, -direction) * light.cone_scale + light.cone_offset, 0.0, 1.0);
        falloff *= cone * cone;
    }
    return Incident(direction, light.intensity * falloff);
}
#endif
