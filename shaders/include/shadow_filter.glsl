// Looks up a point in a shadow map of a distant light. Filter: a tent over 4 × 4 texels, Castaño 2013, "Shadow Mapping
// Summary". Depths are compared along the plane of the surface: Isidoro 2006, "Shadow Mapping: GPU-based Tips and
// Techniques". An offset along the normal, proportional to the texel size, removes the remaining errors: Holbert 2011,
// "Saying Goodbye to Shadow Acne".
#ifndef WEFT_SHADOW_FILTER
#define WEFT_SHADOW_FILTER

// Largest slope of a surface that the comparison of depths follows. The slope is the tangent of the angle between the
// normal and the direction to the light.
const float kShadowMostSlope = 2.5;
// kShadowReach: half the width of the filter's 4 × 4 texels. kShadowQuadReach: distance in x and in y from the corner
// that 2 × 2 texels share to their centres. Units: texels.
const float kShadowReach = 2.0, kShadowQuadReach = 0.5;
// Offset along the light, in texels, for rounding errors and for normals that differ from the real surface. With 0.5,
// planes under a low sun get darker stripes. With 1, none of the built-in scenes has stripes; the remaining 0.5 is a
// reserve.
const float kShadowBiasTexels = 1.5;

// A shadow map of one light: a parallel projection along the direction of the light.
struct ShadowMap {
    mat4 world_to_map;  // World to (u, v, depth). Depth is linear: 1 nearest to the light, 0 farthest from it.
    vec2 size;          // Width and height, in texels.
    vec2 texel_m;       // Width and height of a texel.
    float depth_m;      // Distance from depth 1 to depth 0.
    float layer;
};

struct ShadowPlace {
    vec3 at;       // Position in texels (x, y), and depth in the map (z).
    vec2 slope;    // Slope of the surface in the map: change of depth per texel.
    vec2 size;     // Width and height of the map, in texels.
    float layer;
};

// Finds the place of a point in a map. `across` is the part of the normal along the rows and columns of the map. On a
// plane, depth changes by -across / cos_light per metre. An offset of d along the normal raises the depth of the plane
// by d / cos_light. The slope is clamped for steep planes. The offset makes up for the clamping, and for the
// differences within 2 × 2 texels, so that a plane does not shadow itself.
ShadowPlace place_in_map(ShadowMap map, vec3 to_light, vec3 position, vec3 normal) {
    const float cos_light = max(dot(normal, to_light), 1e-3);
    const float sin_light = sqrt(max(0.0, 1.0 - cos_light * cos_light));
    const vec2 across = mat3x2(map.world_to_map) * normal * (map.size * map.texel_m);
    const float steepest = max(cos_light, sin_light / kShadowMostSlope);
    const float reach = kShadowQuadReach + kShadowReach * (1.0 - cos_light / steepest);
    const float offset_m = reach * dot(abs(across), map.texel_m);
    const float bias_m = kShadowBiasTexels * max(map.texel_m.x, map.texel_m.y);
    const vec3 moved = position + normal * offset_m + to_light * bias_m;
    const vec3 place = (map.world_to_map * vec4(moved, 1.0)).xyz;
    const vec2 slope = -across / steepest * (map.texel_m / map.depth_m);
    return ShadowPlace(vec3(place.xy * map.size, place.z), slope, map.size, map.layer);
}

// Returns the distance in texels from the nearest edge of the map, minus half the width of the filter.
float inside_of_map(ShadowPlace place) {
    const vec2 inside = min(place.at.xy, place.size - place.at.xy) - kShadowReach;
    return min(inside.x, inside.y);
}

// Returns the lit share of the tent filter, from four gathers of 2 × 2 texels. In x, the four texels have the
// weights 1 − f, 2 − f, 1 + f and f, where f is the distance in x from the centre of the second texel to the
// point, in texels. The same holds for y.
float lit_share(sampler2DArrayShadow maps, ShadowPlace place) {
    const vec2 second = floor(place.at.xy - 0.5);
    const vec2 f = place.at.xy - 0.5 - second;
    const mat2 wx = mat2(1.0 - f.x, 2.0 - f.x, 1.0 + f.x, f.x);
    const mat2 wy = mat2(1.0 - f.y, 2.0 - f.y, 1.0 + f.y, f.y);
    float sum = 0.0;
    for (int y = 0; y < 2; ++y) {
        for (int x = 0; x < 2; ++x) {
            const vec2 corner = second + vec2(2 * x, 2 * y);  // The corner that the four texels share.
            // A point may be farther from the light than the far end of the map's range (depth 0). It is compared at
            // this end, so that empty texels, whose depth is 0, do not shadow it.
            const float z = clamp(place.at.z + dot(place.slope, corner - place.at.xy), 0.0, 1.0);
            const vec4 lit = textureGather(maps, vec3(corner / place.size, place.layer), z);
            sum += dot(lit, vec4(wx[x].x * wy[y].y, wx[x].y * wy[y].y, wx[x].y * wy[y].x, wx[x].x * wy[y].x));
        }
    }
    return sum / 16.0;
}
#endif
