// Computes the light that a surface reflects to the eye from the directional lights. These are the first lights in the
// buffer `lights`. For the first four of them, the result takes shadows into account: the light is multiplied by the
// share of the light that is visible from the surface.
#ifndef WEFT_DIRECTIONAL_LIGHTS
#define WEFT_DIRECTIONAL_LIGHTS
#include "disc_light.glsl"
#include "further_sun_shadow.glsl"
#include "light_reflection.glsl"
#include "sun_shadow.glsl"

layout(std430) readonly buffer Lights { Light items[]; } lights;

vec3 directional_reflection(Surface s, vec3 v, vec3 position) {
    const uint count = min(frame.directional_count, uint(lights.items.length()));
    if (count == 0u) return vec3(0.0);
    const float sunshine = sun_visibility(position, s.normal, distance(position, view.eye));
    vec3 radiance = vec3(0.0);
    for (uint i = 0u; i < count; ++i) {
        const uint shadow = lights.items[i].shadow;
        float visible = shadow == 1u ? sunshine : 1.0;
        if (HAS_furtherSunShadow && shadow > 1u) visible = further_sun_visibility(shadow, position, s.normal);
        if (visible <= 0.0) continue;
        const Light light = lights.items[i];
        const float radius = disc_radius_rad(light);
        vec3 reflected = vec3(0.0);
        // These loops run at most once. They replace if and else, because devices that execute both sides of a branch
        // (llvmpipe) leave out a loop that does not run.
        for (bool is_point = radius <= 0.0; is_point; is_point = false)
            reflected = plain_reflection(s, v, position, light);
        for (bool is_disc = radius > 0.0; is_disc; is_disc = false)
            reflected = reflect_disc(s, v, -light.direction, radius) * light.intensity;
        reflected *= visible;
        if (LIGHT_FUNCTIONS && light.function != 0u) reflected *= light_function(light, position);
        radiance += reflected;
    }
    return radiance;
}
#endif
