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
// kSunReach: half the diagonal of the filter's 4 × 4 texels. kSunQuadReach: distance from the corner that 2 × 2 texels
// share to their centres. Units: texels.
const float kSunReach = 2.8284, kSunQuadReach = 0.7071;
// Offset along the light, in texels, for rounding errors and for normals that differ from the real surface.
const float kSunBiasTexels = 1.0;

struct SunPlace {
    uint cascade;
    vec3 at;       // Position in texels (x, y), and depth in the map (z).
    vec2 slope;    // Slope of the surface in the map: change of depth per texel.
    vec2 size;     // Width and height of the map, in texels.
};

// Finds the place of a point in map i. On a plane tilted by θ against the map, depth changes by tan θ per texel, and an
// offset d along the normal raises the depth by d / cos θ. The slope is clamped for steep planes. The offset makes up
// for the clamping, so that a plane does not shadow itself.
SunPlace place_in_map(uint i, vec3 position, vec3 normal) {
    const SunCascade cascade = sun.cascades[i];
    const vec2 size = vec2(textureSize(sunShadow, 0).xy);
    const float cos_light = max(dot(normal, sun.to_sun), 1e-3);
    const float sin_light = sqrt(max(0.0, 1.0 - cos_light * cos_light));
    const vec2 across = mat3x2(cascade.world_to_map) * normal * (size * cascade.texel_m);
    const vec2 slope = -across / max(cos_light, sin_light / kSunMostSlope);
    const float offset = kSunQuadReach * sin_light + kSunReach * max(0.0, sin_light - kSunMostSlope * cos_light);
    const vec3 moved = position + (normal * offset + sun.to_sun * kSunBiasTexels) * cascade.texel_m;
    const vec3 place = (cascade.world_to_map * vec4(moved, 1.0)).xyz;
    return SunPlace(i, vec3(place.xy * size, place.z), slope * (cascade.texel_m / cascade.depth_m), size);
}

bool is_in_map(SunPlace place) {
    return all(greaterThanEqual(place.at.xy, vec2(2.0))) && all(lessThanEqual(place.at.xy, place.size - 2.0));
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

// Returns 1 for full sunlight and 0 for shadow. `view_distance`: distance from the eye to the point, in metres. At its
// end, each map is blended with the next map, and the last map is blended with full light.
float sun_visibility(vec3 position, vec3 normal, float view_distance) {
    if (!HAS_sunShadow || sun.count == 0u) return 1.0;
    if (dot(normal, sun.to_sun) <= 0.0) return 0.0;
    uint i = 0u;
    while (i < sun.count && view_distance > sun.cascades[i].end_m) ++i;
    float visible = 0.0, rest = 1.0;
    for (; i < sun.count && rest > 0.0; ++i) {
        const SunPlace place = place_in_map(i, position, normal);
        if (!is_in_map(place)) continue;
        const float share = rest * clamp((1.0 - view_distance / sun.cascades[i].end_m) / kSunBlend, 0.0, 1.0);
        visible += share * filtered(place);
        rest -= share;
    }
    return visible + rest;
}
#endif
