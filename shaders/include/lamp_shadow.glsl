// Computes the visible share of a lamp at a point, from the shadow maps in the port `lampShadow` (drawn by
// graphs/modules/lamp_shadows.json). Without the port, nothing is in shadow. A lookup compares the depths of a map with
// the plane of the surface: the depth of the plane is linear in the map. Offsets along the normal and towards the lamp,
// proportional to the size of a texel, remove the remaining errors, as in shadow_filter.glsl.
#ifndef WEFT_LAMP_SHADOW
#define WEFT_LAMP_SHADOW
#include "shared/lamp_shadow.glsl"
#include "shared/light.glsl"

layout(constant_id = 34) const bool HAS_lampShadow = false;
uniform sampler2DArray lampShadow;

// Largest slope of a surface that the comparison of depths follows; see kShadowMostSlope.
const float kLampMostSlope = 2.5;
// Offset towards the lamp, in texels, for rounding errors and for normals that differ from the real surface.
const float kLampBiasTexels = 0.75;

// A view of a lamp: the axes along which the columns, the rows and the distance grow. One of several maps of the lamp
// has the number `face`.
struct LampView {
    vec3 right, down, forward;
    float half_width;  // Half the width of the map at the distance 1.
    uint face;
};

// Returns the view that contains the direction `way` from the lamp.
LampView lamp_view(Light light, vec3 way) {
    const float cosine = -light.cone_offset / light.cone_scale;
    if (light.type == kLightSpot && cosine >= kLeastSpotCosine)
        return LampView(light.side, cross(light.direction, light.side), light.direction,
                        kLampMapMargin * sqrt(1.0 - cosine * cosine) / cosine, 0u);
    const vec3 size = abs(way);
    if (size.x >= size.y && size.x >= size.z) {
        const float s = way.x < 0.0 ? -1.0 : 1.0;
        return LampView(vec3(0.0, 0.0, -s), vec3(0.0, -1.0, 0.0), vec3(s, 0.0, 0.0), kLampMapMargin, way.x < 0.0 ? 1u : 0u);
    }
    if (size.y >= size.z) {
        const float s = way.y < 0.0 ? -1.0 : 1.0;
        return LampView(vec3(1.0, 0.0, 0.0), vec3(0.0, 0.0, s), vec3(0.0, s, 0.0), kLampMapMargin, way.y < 0.0 ? 3u : 2u);
    }
    const float s = way.z < 0.0 ? -1.0 : 1.0;
    return LampView(vec3(s, 0.0, 0.0), vec3(0.0, -1.0, 0.0), vec3(0.0, 0.0, s), kLampMapMargin, way.z < 0.0 ? 5u : 4u);
}

vec3 in_lamp_view(LampView seen, vec3 way) { return vec3(dot(seen.right, way), dot(seen.down, way), dot(seen.forward, way)); }

// The place of a point in a map. Depths on the plane of the surface: depth + dot(slope, offset from `at` in texels).
struct LampPlace {
    vec2 at;       // Position in the map, in texels.
    float depth;   // Reversed depth, as in the map.
    vec2 slope;
    float layer;
};

// Finds the place of a point. `way`: from the lamp to the point. `reach`: radius of the filter, in texels.
LampPlace place_in_lamp_map(Light light, vec3 way, vec3 normal, float reach) {
    const float size = float(textureSize(lampShadow, 0).x);
    LampView seen = lamp_view(light, way);
    const vec3 to_light = -normalize(way);
    const float cos_light = max(dot(normal, to_light), 1e-3);
    const float sin_light = sqrt(max(1.0 - cos_light * cos_light, 0.0));
    const float steepest = max(cos_light, sin_light / kLampMostSlope);
    const float texel_m = 2.0 * seen.half_width / size * dot(seen.forward, way);
    const float offset = sin_light * (0.5 + reach * (1.0 - cos_light / steepest));
    const vec3 moved = way + texel_m * (1.41421356 * offset * normal + kLampBiasTexels * to_light);
    seen = lamp_view(light, moved);
    const vec3 p = in_lamp_view(seen, moved);
    const float w = max(p.z, kLampMapNear_m), texels = 0.5 * size / seen.half_width;
    const vec2 slope = in_lamp_view(seen, normal).xy * (-kLampMapNear_m / (steepest * length(p) * texels));
    return LampPlace(p.xy / w * texels + 0.5 * size, kLampMapNear_m / w, slope,
                     float(light.shadow - kFirstLampMap + seen.face));
}

// Returns the lit share of the four texels around the place, weighted by their distances.
float lit_texels(LampPlace place) {
    const vec2 size = vec2(textureSize(lampShadow, 0).xy), second = floor(place.at - 0.5), f = place.at - 0.5 - second;
    const vec4 depths = textureGather(lampShadow, vec3((second + 1.0) / size, place.layer));
    const vec2 low = place.slope * -f, high = place.slope * (1.0 - f);
    const vec4 plane = place.depth + vec4(low.x + high.y, high.x + high.y, high.x + low.y, low.x + low.y);
    const vec4 weights = vec4((1.0 - f.x) * f.y, f.x * f.y, f.x * (1.0 - f.y), (1.0 - f.x) * (1.0 - f.y));
    return dot(weights, vec4(lessThanEqual(depths, plane)));
}

// Returns 1 if the whole lamp is visible from the point, and 0 if nothing of it is.
float lamp_visibility(Light light, vec3 position, vec3 normal) {
    if (!HAS_lampShadow || light.shadow < kFirstLampMap) return 1.0;
    const vec3 way = position - light.position;
    return lit_texels(place_in_lamp_map(light, way, normal, 1.0));
}
#endif
