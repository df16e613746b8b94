// Computes the light that a surface reflects to the eye from one lamp, without the part of the light that other surfaces
// hide. Units: cd/m². Optional port: `lampShadow` of lamp_shadow.glsl. For the loops that run at most once, see
// directional_lights.glsl.
#ifndef WEFT_LAMP_REFLECTION
#define WEFT_LAMP_REFLECTION
#include "lamp_shadow.glsl"
#include "light_reflection.glsl"

// Returns true if shadow maps may change the light of the lamp.
bool has_shadow(Light light) { return HAS_lampShadow && light.shadow >= kFirstLampMap; }

vec3 plain_lamp_reflection(Surface s, vec3 v, vec3 position, Light light) {
    const Incident incident = light_at(light, position);
    vec3 reflected = vec3(0.0);
    for (bool lit = incident.irradiance != vec3(0.0) && dot(s.normal, incident.direction) > 0.0; lit; lit = false) {
        reflected = reflect_light(s, v, incident.direction) * incident.irradiance;
        if (has_shadow(light)) reflected *= sharp_visibility(light, position, s.normal);
    }
    return reflected;
}

vec3 lamp_reflection(Surface s, vec3 v, vec3 position, Light light) {
    vec3 reflected = light_reflection(s, v, position, light);
    for (bool hides = has_shadow(light) && reflected != vec3(0.0); hides; hides = false)
        reflected *= AREA_LIGHTS ? lamp_visibility(light, position, s.normal)
                                 : sharp_visibility(light, position, s.normal);
    return reflected;
}
#endif
