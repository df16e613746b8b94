// Computes the light that a surface reflects to the eye from one light of any type. Units: cd/m².
//
// A shader can switch off features that its lights do not need: AREA_LIGHTS if there are no capsules and no rectangles,
// LIGHT_FUNCTIONS if no light has doors, a picture or a curve. The shader declares the constant before it includes this
// file:
//     layout(constant_id = 3) const bool AREA_LIGHTS = true;
//     #define AREA_LIGHTS AREA_LIGHTS
#ifndef WEFT_LIGHT_REFLECTION
#define WEFT_LIGHT_REFLECTION
#include "brdf.glsl"
#include "frame_set.glsl"
#include "lights.glsl"

#ifndef AREA_LIGHTS
const bool AREA_LIGHTS = true;
#endif
#ifndef LIGHT_FUNCTIONS
const bool LIGHT_FUNCTIONS = true;
#endif
#include "area_lights.glsl"
#include "light_function.glsl"

// Returns the reflection of a light without area, and ignores its light function. The first frame.plain_count
// lights of the buffer have neither an area nor a light function. A separate loop for them saves time on
// devices that execute both sides of a branch (llvmpipe).
vec3 plain_reflection(Surface s, vec3 v, vec3 position, Light light) {
    const Incident incident = light_at(light, position);
    return reflect_light(s, v, incident.direction) * incident.irradiance;
}

vec3 light_reflection(Surface s, vec3 v, vec3 position, Light light) {
    vec3 reflected;
    if (AREA_LIGHTS && light.type >= kLightCapsule) {
        reflected = reflect_area(s, v, position, light) * light.intensity;
    } else {
        reflected = plain_reflection(s, v, position, light);
    }
    if (LIGHT_FUNCTIONS && light.function != 0u) reflected *= light_function(light, position);
    return reflected;
}
#endif
