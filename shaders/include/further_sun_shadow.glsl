// Computes the visible share of the directional lights 2 to 4 at a point, from the shadow maps in the port
// `furtherSunShadow` (drawn by graphs/modules/further_suns.json). Without the port, nothing is in shadow.
// shadow_filter.glsl has the filter.
#ifndef WEFT_FURTHER_SUN_SHADOW
#define WEFT_FURTHER_SUN_SHADOW
#include "frame_set.glsl"
#include "shadow_filter.glsl"
#include "shared/light.glsl"

layout(constant_id = 25) const bool HAS_furtherSunShadow = false;
uniform sampler2DArrayShadow furtherSunShadow;

// `number`: Light::shadow, 2 to kMostSuns. Returns 1 for full light and 0 for shadow.
float further_sun_visibility(uint number, vec3 position, vec3 normal) {
    if (!HAS_furtherSunShadow || number < 2u || number > kMostSuns) return 1.0;
    const FurtherSun light = further_suns.items[number - 2u];
    if (light.texel_m <= 0.0) return 1.0;
    if (dot(normal, light.to_sun) <= 0.0) return 0.0;
    const ShadowMap map = ShadowMap(light.world_to_map, vec2(textureSize(furtherSunShadow, 0).xy), vec2(light.texel_m),
                                    light.depth_m, float(number - 2u));
    const ShadowPlace place = place_in_map(map, light.to_sun, position, normal);
    return inside_of_map(place) < 0.0 ? 1.0 : lit_share(furtherSunShadow, place);
}
#endif
