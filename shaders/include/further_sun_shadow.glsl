// Computes the visible share of the directional lights 2 to 4 at a point, from the shadow maps in the port
// `furtherSunShadow` (drawn by graphs/modules/further_suns.json). Without the port, nothing is in shadow.
#ifndef WEFT_FURTHER_SUN_SHADOW
#define WEFT_FURTHER_SUN_SHADOW
#include "frame_set.glsl"
#include "shared/light.glsl"
#include "whole_shadow.glsl"

layout(constant_id = 25) const bool HAS_furtherSunShadow = false;
uniform sampler2DArrayShadow furtherSunShadow;

// `number`: Light::shadow, 2 to kMostSuns. Returns 1 for full light and 0 for shadow.
float further_sun_visibility(uint number, vec3 position, vec3 normal) {
    if (!HAS_furtherSunShadow || number < 2u || number > kMostSuns) return 1.0;
    return whole_visibility(furtherSunShadow, number - 2u, further_suns.items[number - 2u], position, normal);
}
#endif
