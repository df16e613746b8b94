// What a surface sends to the eye of all lights and of the sky, but for its own emission. Units: cd/m². Deferred and
// forward shading share it. Needs brdf.glsl, frame_set.glsl, lights.glsl and sky.glsl, and a buffer port `lights`.
#include "light_reflection.glsl"

vec3 reflected_radiance(Surface s, vec3 position, vec3 orm) {
    const vec3 v = normalize(view.eye - position);
    vec3 radiance = vec3(0.0);
    const uint count = min(frame.light_count, uint(lights.items.length()));
    uint i = 0u;
    for (; i < min(frame.plain_count, count); ++i) radiance += plain_reflection(s, v, position, lights.items[i]);
    for (; i < count; ++i) radiance += light_reflection(s, v, position, lights.items[i]);
    return radiance + orm.r * ambient_reflection(s.normal, v, s.diffuse, s.f0, s.f90, orm.g);
}
