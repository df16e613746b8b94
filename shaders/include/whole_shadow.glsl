// Computes the visible share of a directional light at a point, from a shadow map that covers a whole scene. The filter
// is a tent over 4 × 4 texels, and depths are compared along the plane of the surface; see sun_shadow.glsl for sources.
#ifndef WEFT_WHOLE_SHADOW
#define WEFT_WHOLE_SHADOW
#include "shared/further_suns.glsl"

// Largest slope of a surface that the comparison of depths follows.
const float kWholeMostSlope = 2.0;

// `layer`: the layer of `maps` with the map of the light. Returns 1 for full light and 0 for shadow. A light without a
// map has no shadows.
float whole_visibility(sampler2DArrayShadow maps, uint layer, FurtherSun light, vec3 position, vec3 normal) {
    const float cos_light = dot(normal, light.to_sun);
    if (light.texel_m <= 0.0) return 1.0;
    if (cos_light <= 0.0) return 0.0;
    const vec2 size = vec2(textureSize(maps, 0).xy);
    const float sin_light = sqrt(max(0.0, 1.0 - cos_light * cos_light));
    const vec2 across = mat3x2(light.world_to_map) * normal * (size * light.texel_m);
    const float steepest = max(max(cos_light, 1e-3), sin_light / kWholeMostSlope);
    const vec2 slope = -across / steepest * (light.texel_m / light.depth_m);
    // The offset along the normal makes up for the clamped slope, and for the differences within 2 × 2 texels. The
    // offset towards the light by one texel makes up for rounding.
    const float offset = 0.7071 * sin_light + 2.8284 * max(0.0, sin_light - kWholeMostSlope * cos_light);
    const vec3 moved = position + (normal * offset + light.to_sun) * light.texel_m;
    const vec3 place = (light.world_to_map * vec4(moved, 1.0)).xyz;
    const vec2 at = place.xy * size;
    if (any(lessThan(at, vec2(2.0))) || any(greaterThan(at, size - 2.0))) return 1.0;
    const vec2 second = floor(at - 0.5);
    const vec2 f = at - 0.5 - second;
    const mat2 wx = mat2(1.0 - f.x, 2.0 - f.x, 1.0 + f.x, f.x);
    const mat2 wy = mat2(1.0 - f.y, 2.0 - f.y, 1.0 + f.y, f.y);
    float sum = 0.0;
    for (int y = 0; y < 2; ++y) {
        for (int x = 0; x < 2; ++x) {
            const vec2 corner = second + vec2(2 * x, 2 * y);  // The corner that the four texels share.
            const float z = clamp(place.z + dot(slope, corner - at), 0.0, 1.0);
            const vec4 lit = textureGather(maps, vec3(corner / size, float(layer)), z);
            sum += dot(lit, vec4(wx[x].x * wy[y].y, wx[x].y * wy[y].y, wx[x].y * wy[y].x, wx[x].x * wy[y].x));
        }
    }
    return sum / 16.0;
}
#endif
