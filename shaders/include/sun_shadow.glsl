// Computes the visible share of the sun at a point, from the shadow maps in the port `sunShadow` (drawn by
// graphs/modules/sun_shadows.json). Without the port or without a sun, nothing is in shadow. Filter: a tent over 4 × 4
// texels, Castaño 2013, "Shadow Mapping Summary". Depths are compared along the plane of the surface: Isidoro 2006,
// "Shadow Mapping: GPU-based Tips and Techniques". An offset along the normal, proportional to the texel size, removes
// the remaining errors: Holbert 2011, "Saying Goodbye to Shadow Acne".
#ifndef WEFT_SUN_SHADOW
#define WEFT_SUN_SHADOW
#include "frame_set.glsl"

layout(constant_id = 20) const bool HAS_sunShadow = false;
uniform sampler2DArrayShadow sunShadow;

// Largest slope of a surface that the comparison of depths follows. The slope is the tangent of the angle between the
// normal and the direction to the sun.
const float kSunMostSlope = 2.0;
// kSunReach: half the width of the filter's 4 × 4 texels. kSunQuadReach: distance in x and in y from the corner that
// 2 × 2 texels share to their centres. Units: texels.
const float kSunReach = 2.0, kSunQuadReach = 0.5;
// Offset along the light, in texels, for rounding errors and for normals that differ from the real surface.
const float kSunBiasTexels = 1.5;

struct SunPlace {
    uint cascade;
    vec3 at;       // Position in texels (x, y), and depth in the map (z).
    vec2 slope;    // Slope of the surface in the map: change of depth per texel.
    vec2 size;     // Width and height of the map, in texels.
};

// Finds the place of a point in map i. `across` is the part of the normal along the rows and columns of the map. On a
// plane, depth changes by -across / cos_light per metre. An offset along the normal of d raises the depth by
// d / cos_light. The slope is clamped for steep planes. The offset makes up for the clamping, and for the differences
// within 2 × 2 texels, so that a plane does not shadow itself.
SunPlace place_in_map(uint i, vec3 position, vec3 normal) {
    const SunCascade cascade = sun.cascades[i];
    const vec2 size = vec2(textureSize(sunShadow, 0).xy);
    const float cos_light = max(dot(normal, sun.to_sun), 1e-3);
    const float sin_light = sqrt(max(0.0, 1.0 - cos_light * cos_light));
    const vec2 across = mat3x2(cascade.world_to_map) * normal * (size * cascade.texel_m);
    const float steepest = max(cos_light, sin_light / kSunMostSlope);
    const float reach = kSunQuadReach + kSunReach * (1.0 - cos_light / steepest);
    const float offset_m = reach * dot(abs(across), cascade.texel_m);
    const float bias_m = kSunBiasTexels * max(cascade.texel_m.x, cascade.texel_m.y);
    const vec3 moved = position + normal * offset_m + sun.to_sun * bias_m;
    const vec3 place = (cascade.world_to_map * vec4(moved, 1.0)).xyz;
    const vec2 slope = -across / steepest * (cascade.texel_m / cascade.depth_m);
    return SunPlace(i, vec3(place.xy * size, place.z), slope, size);
}

// Returns 0 at the edge of the map's usable part and outside, and 1 where the map needs no blending with the next one.
float share_of_map(SunPlace place) {
    const vec2 inside = min(place.at.xy, place.size - place.at.xy) - 2.0;
    return clamp(min(inside.x, inside.y) / kSunBlendTexels, 0.0, 1.0);
}

// Returns the lit share of the tent filter, from four gathers of 2 × 2 texels. In x, the four texels have the
// weights 1 − f, 2 − f, 1 + f and f, where f is the distance in x from the centre of the second texel to the
// point, in texels. The same holds for y.
float filtered(SunPlace place) {
    const vec2 second = floor(place.at.xy - 0.5);
    const vec2 f = place.at.xy - 0.5 - second;
    const mat2 wx = mat2(1.0 - f.x, 2.0 - f.x, 1.0 + f.x, f.x);
    const mat2 wy = mat2(1.0 - f.y, 2.0 - f.y, 1.0 + f.y, f.y);
    float sum = 0.0;
    for (int y = 0; y < 2; ++y) {
        for (int x = 0; x < 2; ++x) {
            const vec2 corner = second + vec2(2 * x, 2 * y);  // The corner that the four texels share.
            // A point may be farther from the sun than the far end of the map's range (depth 0). It is compared at
            // this end, so that empty texels, whose depth is 0, do not shadow it.
            const float z = clamp(place.at.z + dot(place.slope, corner - place.at.xy), 0.0, 1.0);
            const vec4 lit = textureGather(sunShadow, vec3(corner / place.size, float(place.cascade)), z);
            sum += dot(lit, vec4(wx[x].x * wy[y].y, wx[x].y * wy[y].y, wx[x].y * wy[y].x, wx[x].x * wy[y].x));
        }
    }
    return sum / 16.0;
}

// Returns 1 for full sunlight and 0 for shadow. `view_distance`: distance from the eye to the point, in metres. The
// first map that contains the point decides. Near its edge, it is blended with the next map that contains the point.
// Points that no map contains are lit.
float sun_visibility(vec3 position, vec3 normal, float view_distance) {
    if (!HAS_sunShadow || sun.count == 0u) return 1.0;
    if (dot(normal, sun.to_sun) <= 0.0) return 0.0;
    float visible = 0.0, rest = 1.0;
    for (uint i = 0u; i < sun.count && rest > 0.0; ++i) {
        const SunPlace place = place_in_map(i, position, normal);
        const float share = rest * share_of_map(place);
        if (share <= 0.0) continue;
        visible += share * filtered(place);
        rest -= share;
    }
    if (rest >= 1.0) return 1.0;
    const float shaded = clamp((1.0 - view_distance / sun.cascades[0].end_m) / kSunFade, 0.0, 1.0);
    return mix(1.0, visible / (1.0 - rest), shaded);
}
#endif
