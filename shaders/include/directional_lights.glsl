// Computes the light that a surface reflects to the eye from the directional lights. These are the first lights in the
// buffer `lights`. The light of the sun is multiplied by the visible share of the sun (shadows).
#ifndef WEFT_DIRECTIONAL_LIGHTS
#define WEFT_DIRECTIONAL_LIGHTS
#include "light_reflection.glsl"
#include "sun_shadow.glsl"

layout(std430) readonly buffer Lights { Light items[]; } lights;

vec3 directional_reflection(Surface s, vec3 v, vec3 position) {
    const uint count = min(frame.directional_count, uint(lights.items.length()));
    if (count == 0u) return vec3(0.0);
    const float sunshine = sun_visibility(position, s.normal, distance(position, view.eye));
    vec3 radiance = vec3(0.0);
    for (uint i = 0u; i < count; ++i) {
        const float visible = lights.items[i].shadow == 0u ? 1.0 : sunshine;
        if (visible <= 0.0) continue;
        vec3 reflected = plain_reflection(s, v, position, lights.items[i]) * visible;
        if (LIGHT_FUNCTIONS && lights.items[i].function != 0u) reflected *= light_function(lights.items[i], position);
        radiance += reflected;
    }
    return radiance;
}
#endif
