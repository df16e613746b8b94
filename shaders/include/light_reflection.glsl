// What a surface sends to the eye of one light, whatever its kind. Units: cd/m².
//
// A shader that knows its lights leaves out what they don't need: AREA_LIGHTS where none is a capsule or rectangle,
// LIGHT_FUNCTIONS where none has doors, a picture or a curve. It declares the constant before it includes this file:
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

// Of a light that has neither an area nor a function. Those are the first frame.plain_count, so a loop of their own spares
// machines that walk both sides of every branch (llvmpipe) the rest.
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
