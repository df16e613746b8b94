// Computes the visible share of the sun at a point, from the shadow maps in the port `sunShadow` (drawn by
// graphs/modules/sun_shadows.json). Without the port or without a sun, nothing is in shadow. shadow_filter.glsl has the
// filter.
#ifndef WEFT_SUN_SHADOW
#define WEFT_SUN_SHADOW
#include "frame_set.glsl"
#include "shadow_filter.glsl"

layout(constant_id = 20) const bool HAS_sunShadow = false;
uniform sampler2DArrayShadow sunShadow;

// Returns 1 for full sunlight and 0 for shadow. `view_distance`: distance from the eye to the point, in metres. The
// first map that contains the point decides. Near its edge, this map is blended with the next map that contains the
// point. Points that no map contains are lit.
float sun_visibility(vec3 position, vec3 normal, float view_distance) {
    if (!HAS_sunShadow || sun.count == 0u) return 1.0;
    if (dot(normal, sun.to_sun) <= 0.0) return 0.0;
    const vec2 size = vec2(textureSize(sunShadow, 0).xy);
    float visible = 0.0, rest = 1.0;
    for (uint i = 0u; i < sun.count && rest > 0.0; ++i) {
        const SunCascade cascade = sun.cascades[i];
        const ShadowMap map = ShadowMap(cascade.world_to_map, size, cascade.texel_m, cascade.depth_m, float(i));
        const ShadowPlace place = place_in_map(map, sun.to_sun, position, normal);
        const float share = rest * clamp(inside_of_map(place) / kSunBlendTexels, 0.0, 1.0);
        if (share <= 0.0) continue;
        visible += share * lit_share(sunShadow, place);
        rest -= share;
    }
    if (rest >= 1.0) return 1.0;
    const float shaded = clamp((1.0 - view_distance / sun.cascades[0].end_m) / kSunFade, 0.0, 1.0);
    return mix(1.0, visible / (1.0 - rest), shaded);
}
#endif
