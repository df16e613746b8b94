// Computes the visible share of a directional light at a point, from a shadow map that covers a whole scene.
#ifndef WEFT_WHOLE_SHADOW
#define WEFT_WHOLE_SHADOW
#include "shadow_filter.glsl"
#include "shared/further_suns.glsl"

// `layer`: the layer of `maps` with the map of the light. Returns 1 for full light and 0 for shadow. A light without a
// map has no shadows.
float whole_visibility(sampler2DArrayShadow maps, uint layer, FurtherSun light, vec3 position, vec3 normal) {
    if (light.texel_m <= 0.0) return 1.0;
    if (dot(normal, light.to_sun) <= 0.0) return 0.0;
    const ShadowMap map = ShadowMap(light.world_to_map, vec2(textureSize(maps, 0).xy), vec2(light.texel_m), light.depth_m,
                                    float(layer));
    const ShadowPlace place = place_in_map(map, light.to_sun, position, normal);
    return inside_of_map(place) < 0.0 ? 1.0 : lit_share(maps, place);
}
#endif
