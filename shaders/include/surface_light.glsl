// Computes the light that a surface reflects to the eye from all lights and the sky, without the light that the surface
// emits. Units: cd/m². Deferred and forward shading both use this file. Ports: the buffer `lights`, and optionally the
// ports of ambient.glsl, the shadow maps `sunShadow` and `lampShadow`, and the lists `tileLights` of the lights that
// reach each tile. With lists, only the lights of the pixel's tile are added, in the same order as without lists. If a
// list is complete, all other lights would add exactly 0, so the sum has the same bits with and without lists.
#ifndef WEFT_SURFACE_LIGHT
#define WEFT_SURFACE_LIGHT
#include "ambient.glsl"
#include "brdf.glsl"
#include "directional_lights.glsl"
#include "frame_set.glsl"
#include "lamp_reflection.glsl"
#include "lights.glsl"
#include "tile_lights.glsl"

layout(constant_id = 15) const bool HAS_tileLights = false;

// Returns the reflection of all lights: directional lights, then the lights in the list of the tile of `pixel`. Without
// lists: directional lights, then all other lights.
vec3 lights_reflection(Surface s, vec3 v, vec3 position, ivec2 pixel) {
    const uint all = min(frame.light_count, uint(lights.items.length()));
    const uint directional = min(frame.directional_count, all);
    const uint list = HAS_tileLights ? tile_list(pixel) : 0u;
    const uint listed = HAS_tileLights ? tileLights.items[list] : all - directional;
    vec3 radiance = directional_reflection(s, v, position);
    uint i = 0u, index = 0u;
    for (; i < listed; ++i) {
        index = HAS_tileLights ? tileLights.items[list + 1u + i] : directional + i;
        if (index >= frame.unshadowed_count) break;
        radiance += plain_reflection(s, v, position, lights.items[index]);
    }
    for (; i < listed; ++i) {
        index = HAS_tileLights ? tileLights.items[list + 1u + i] : directional + i;
        if (index >= frame.plain_count) break;
        radiance += plain_lamp_reflection(s, v, position, lights.items[index]);
    }
    for (; i < listed; ++i) {
        index = HAS_tileLights ? tileLights.items[list + 1u + i] : directional + i;
        radiance += lamp_reflection(s, v, position, lights.items[index]);
    }
    return radiance;
}

// `v`: unit vector from the surface to the eye. `orm`: occlusion, perceptual roughness, metalness.
vec3 reflected_radiance(Surface s, vec3 v, vec3 position, vec3 orm, ivec2 pixel) {
    s = with_albedo(s, v);
    return lights_reflection(s, v, position, pixel) + orm.r * ambient_reflection(s, v, orm.g, position, pixel);
}
#endif
