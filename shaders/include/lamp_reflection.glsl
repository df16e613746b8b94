// Computes the light that a surface reflects to the eye from one lamp, without the part of the light that other surfaces
// hide. Units: cd/m². Optional port: `lampShadow` of lamp_shadow.glsl.
#ifndef WEFT_LAMP_REFLECTION
#define WEFT_LAMP_REFLECTION
#include "lamp_shadow.glsl"
#include "light_reflection.glsl"

vec3 without_shadow(vec3 reflected, Surface s, vec3 position, Light light) {
    if (!HAS_lampShadow || light.shadow < kFirstLampMap || reflected == vec3(0.0)) return reflected;
    return reflected * lamp_visibility(light, position, s.normal);
}

vec3 plain_lamp_reflection(Surface s, vec3 v, vec3 position, Light light) {
    return without_shadow(plain_reflection(s, v, position, light), s, position, light);
}

vec3 lamp_reflection(Surface s, vec3 v, vec3 position, Light light) {
    return without_shadow(light_reflection(s, v, position, light), s, position, light);
}
#endif
