// What a surface sends to the eye of all lights and of the sky, but for its own emission. Units: cd/m². Deferred and
// forward shading share it. Needs brdf.glsl, frame_set.glsl, lights.glsl and sky.glsl, and a buffer port `lights`.
#include "sun_shadow.glsl"

vec3 reflected_radiance(Surface s, vec3 position, vec3 orm) {
    const vec3 v = normalize(view.eye - position);
    vec3 radiance = vec3(0.0);
    const uint count = min(frame.light_count, uint(lights.items.length()));
    const float sunshine = sun_visibility(position, s.normal, distance(position, view.eye));
    for (uint i = 0u; i < count; ++i) {
        const Incident light = light_at(lights.items[i], position);
        const float visible = lights.items[i].shadow == 0u ? 1.0 : sunshine;
        radiance += reflect_light(s, v, light.direction) * light.irradiance * visible;
    }
    return radiance + orm.r * ambient_reflection(s.normal, v, s.diffuse, s.f0, s.f90, orm.g);
}
