// Computes the visible share of a lamp at a point, from the shadow maps in the port `lampShadow` (drawn by
// graphs/modules/lamp_shadows.json). A lookup compares the depths of a map with the plane of the surface, whose depth
// is linear in the map. Offsets along the normal and towards the lamp, proportional to the size of a texel, remove
// the remaining errors, as in shadow_filter.glsl. Shadows of capsules and rectangles have soft edges, whose widths follow
// from the size of the lamp and from the mean depth of the surfaces that hide it: Fernando 2005, "Percentage-Closer Soft
// Shadows".
#ifndef WEFT_LAMP_SHADOW
#define WEFT_LAMP_SHADOW
#include "lights.glsl"
#include "shared/lamp_shadow.glsl"

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
    const float cosine = cone_edge(light);
    if (light.type == kLightSpot && cosine >= kLeastSpotCosine)
        return LampView(light.side, cross(light.direction, light.side), light.direction,
                        kLampMapMargin * sqrt(1.0 - cosine * cosine) / cosine, 0u);
    const vec3 size = abs(way);
    if (size.x >= size.y && size.x >= size.z) {
        const float s = way.x < 0.0 ? -1.0 : 1.0;
        return LampView(vec3(0.0, 0.0, -s), vec3(0.0, -1.0, 0.0), vec3(s, 0.0, 0.0), kLampMapMargin, s < 0.0 ? 1u : 0u);
    }
    if (size.y >= size.z) {
        const float s = way.y < 0.0 ? -1.0 : 1.0;
        return LampView(vec3(1.0, 0.0, 0.0), vec3(0.0, 0.0, s), vec3(0.0, s, 0.0), kLampMapMargin, s < 0.0 ? 3u : 2u);
    }
    const float s = way.z < 0.0 ? -1.0 : 1.0;
    return LampView(vec3(s, 0.0, 0.0), vec3(0.0, -1.0, 0.0), vec3(0.0, 0.0, s), kLampMapMargin, s < 0.0 ? 5u : 4u);
}

vec3 in_lamp_view(LampView seen, vec3 way) {
    return vec3(dot(seen.right, way), dot(seen.down, way), dot(seen.forward, way));
}

// The place of a point in a map.
struct LampPlace {
    vec2 at;       // Position in the map, in texels.
    float depth;   // As in the map; see shared/lamp_shadow.glsl.
    vec2 slope;    // Change of this depth per texel on the plane of the surface.
    float layer;
};

// The shape of a lamp, as seen from a point: half its width and half its height in the plane of the map. Unit: texels,
// for a lamp that is seen through the plane at the distance 1.
struct LampShape {
    vec2 across, along;
    bool round;
};

// Returns the part of a way in a lamp's view that is left if the lamp is seen from the point at `p`.
vec2 seen_from(vec3 way, vec3 p) { return way.xy - p.xy * (way.z / p.z); }

// Returns the shape of a capsule or a rectangle. A capsule counts as an ellipse, with the outline's length and width.
LampShape lamp_shape(Light light, LampView seen, vec3 p, float texels) {
    vec3 along = cross(light.side, light.direction) * light.half_size_m.y, across = light.side * light.half_size_m.x;
    if (light.type == kLightCapsule) {
        const vec3 sight = normalize(seen.right * p.x + seen.down * p.y + seen.forward * p.z);
        const vec3 axis = light.direction - sight * dot(light.direction, sight);
        const float slant = length(axis);
        along = slant > 1e-3 ? axis / slant : normalize(light.side - sight * dot(light.side, sight));
        across = cross(sight, along) * light.half_size_m.y;
        along *= light.half_size_m.x * slant + light.half_size_m.y;
    }
    return LampShape(seen_from(in_lamp_view(seen, across), p) * texels, seen_from(in_lamp_view(seen, along), p) * texels,
                     light.type == kLightCapsule);
}

// A point as a lamp sees it.
struct LampSight {
    LampView view;
    vec3 p;         // The point in the view, moved by the offsets.
    float texels;   // Texels per unit on the plane at the distance 1.
    LampPlace place;
};

// Finds the place of a point. `way`: from the lamp to the point. `reach`: radius of the filter, in texels. The moved
// point may be outside of the face, but not of the margin around it.
LampSight see_from_lamp(Light light, vec3 way, vec3 normal, float reach) {
    const float size = float(textureSize(lampShadow, 0).x);
    LampSight sight;
    sight.view = lamp_view(light, way);
    const vec3 to_light = -normalize(way);
    const float cos_light = max(dot(normal, to_light), 1e-3);
    const float sin_light = sqrt(max(1.0 - cos_light * cos_light, 0.0));
    const float steepest = max(cos_light, sin_light / kLampMostSlope);
    const float texel_m = 2.0 * sight.view.half_width / size * dot(sight.view.forward, way);
    const float offset = 1.41421356 * sin_light * (0.5 + reach * (1.0 - cos_light / steepest));
    const vec3 moved = way + texel_m * (offset * normal + kLampBiasTexels * to_light);
    sight.p = in_lamp_view(sight.view, moved);
    sight.p.z = max(sight.p.z, kLampMapNear_m);
    sight.texels = 0.5 * size / sight.view.half_width;
    const float reach_m = light.range_m + light.half_size_m.x + light.half_size_m.y;
    const float depth = kLampMapNear_m * (1.0 / sight.p.z - (light.range_m > 0.0 ? 1.0 / reach_m : 0.0));
    const vec2 across = in_lamp_view(sight.view, normal).xy;
    sight.place = LampPlace(sight.p.xy / sight.p.z * sight.texels + 0.5 * size, depth,
                            across * (-kLampMapNear_m / (steepest * length(sight.p) * sight.texels)),
                            float(light.shadow - kFirstLampMap + sight.view.face));
    return sight;
}

// Reads the four texels around the place. Returns for each texel whether it hides nothing (1) or hides the point (0).
vec4 lit_texels(LampPlace place, out vec4 depths, out vec2 f) {
    const vec2 size = vec2(textureSize(lampShadow, 0).xy), second = floor(place.at - 0.5);
    f = place.at - 0.5 - second;
    depths = textureGather(lampShadow, vec3((second + 1.0) / size, place.layer));
    const vec2 low = place.slope * -f, high = place.slope * (1.0 - f);
    const vec4 plane = place.depth + vec4(low.x + high.y, high.x + high.y, high.x + low.y, low.x + low.y);
    return vec4(lessThanEqual(depths, plane));
}

// Returns the lit share of the four texels around the place, weighted by their distances.
float lit_share(LampPlace place) {
    vec4 depths;
    vec2 f;
    const vec4 lit = lit_texels(place, depths, f);
    const vec2 rows = lit.wx + (lit.zy - lit.wx) * f.x;  // This form is exactly 1 if all texels are lit.
    return rows.x + (rows.y - rows.x) * f.y;
}

LampPlace moved_place(LampPlace place, vec2 by) {
    return LampPlace(place.at + by, place.depth + dot(place.slope, by), place.slope, place.layer);
}

// Places of the samples in a shape, from −1 to 1. They are numbers and not arrays, because devices without memory for
// constants (llvmpipe) fill an array again for each pixel.
const int kLampSamples = 16;

// Returns one of Hammersley's points.
vec2 place_in_square(int i) {
    const uint reversed = bitfieldReverse(uint(i)) >> 28;
    return vec2(i, reversed) * 0.125 - 0.9375;
}

// Returns one of 16 points that were optimised: the number of points on one side of a line is nearly proportional to this
// part of the disc. Each number contains two points, as packSnorm4x8() packs them.
vec2 place_in_disc(int i) {
    const uvec4 first = uvec4(0xe3624e43u, 0x1c6102d3u, 0xb242ff99u, 0xa3d5c9acu);
    const uvec4 last = uvec4(0x35acd7f1u, 0x5dd4e324u, 0x640e1927u, 0x2cf59c0eu);
    const vec4 two = unpackSnorm4x8(i < 8 ? first[i >> 1] : last[(i >> 1) - 4]);
    return (i & 1) == 0 ? two.xy : two.zw;
}

vec2 sample_place(LampShape shape, int i) {
    const vec2 at = shape.round ? place_in_disc(i) : place_in_square(i);
    return shape.across * at.x + shape.along * at.y;
}

// Returns how far from the middle of the shape a sample is: 1 at the edge.
float sample_radius(LampShape shape, int i) {
    return shape.round ? length(place_in_disc(i)) : max(abs(place_in_square(i).x), abs(place_in_square(i).y));
}

// Surfaces that hide the lamp are searched where they would be at this share of the distance from the lamp.
const float kNearestHidden = 0.3;
// Largest radius of a filter, as a share of the size of a map.
const float kMostLampFilter = 0.12;

// Returns the factor from a shape to its shadow on the plane of the map, for an edge at the depth `depth`.
float shadow_of_shape(float depth, LampPlace place) { return max(depth - place.depth, 0.0) / kLampMapNear_m; }

// Weight of a surface that is in the searched part of the map, but not between the point and the lamp. Such surfaces
// count only if no other surface is found.
const float kBesides = 0.01;

// Returns the mean depth of the surfaces that may hide the lamp, or 0 if there are none. The samples are dense in the
// middle, because surfaces near the point hide the lamp only there. Whether a surface is between the point and a part of
// the lamp depends on its depth.
float hidden_depth(LampPlace place, LampShape shape, float search) {
    float sum = 0.0, count = 0.0;
    for (int i = 0; i < kLampSamples; ++i) {
        const float radius = sample_radius(shape, i), scale = search * radius * radius;
        vec4 depths;
        vec2 f;
        const vec4 lit = lit_texels(moved_place(place, sample_place(shape, i) * scale), depths, f);
        const float least = place.depth + kLampMapNear_m * scale * radius;
        const vec4 weights = mix(vec4(kBesides), vec4(1.0), greaterThan(depths, vec4(least))) * (1.0 - lit);
        sum += dot(weights, depths);
        count += dot(weights, vec4(1.0));
    }
    return count > 0.0 ? sum / count : 0.0;
}

// Returns the visible share of a lamp with an area.
float soft_visibility(LampSight sight, LampShape shape) {
    const float size = length(shape.across) + length(shape.along);
    const float most = kMostLampFilter * 2.0 * sight.texels / max(size, 1e-6);
    const float search = min((1.0 / kNearestHidden - 1.0) / sight.p.z, most);
    const float depth = hidden_depth(sight.place, shape, search);
    if (depth <= 0.0) return 1.0;
    const float scale = min(shadow_of_shape(depth, sight.place), most);
    float sum = 0.0;
    for (int i = 0; i < kLampSamples; ++i) sum += lit_share(moved_place(sight.place, sample_place(shape, i) * scale));
    return sum / float(kLampSamples);
}

// Returns the lit share of the 4 × 4 texels around the place, with the tent filter of shadow_filter.glsl. An
// edge that crosses the texels at an angle then shows no steps.
float tent_share(LampPlace place) {
    const vec2 size = vec2(textureSize(lampShadow, 0).xy), second = floor(place.at - 0.5);
    const vec2 f = place.at - 0.5 - second;
    const mat2 wx = mat2(1.0 - f.x, 2.0 - f.x, 1.0 + f.x, f.x);
    const mat2 wy = mat2(1.0 - f.y, 2.0 - f.y, 1.0 + f.y, f.y);
    const vec2 half_slope = 0.5 * place.slope;
    const vec4 aside = vec4(half_slope.y - half_slope.x, half_slope.x + half_slope.y, half_slope.x - half_slope.y, -half_slope.x - half_slope.y);
    float hidden = 0.0;
    for (int y = 0; y < 2; ++y)
        for (int x = 0; x < 2; ++x) {
            const vec2 corner = second + vec2(2 * x, 2 * y);
            const vec4 plane = place.depth + dot(place.slope, corner - place.at) + aside;
            const vec4 hides = vec4(greaterThan(textureGather(lampShadow, vec3(corner / size, place.layer)), plane));
            hidden += dot(hides, vec4(wx[x].x * wy[y].y, wx[x].y * wy[y].y, wx[x].y * wy[y].x, wx[x].x * wy[y].x));
        }
    const float share = 1.0 - hidden / 16.0;
    return share < 1e-5 ? 0.0 : share;  // Rounding errors must not let light pass.
}

// Returns the visible share of a lamp without an area. The lamp must have shadow maps.
float sharp_visibility(Light light, vec3 position, vec3 normal) {
    return tent_share(see_from_lamp(light, position - light.position, normal, 2.0).place);
}

// Returns 1 if the whole lamp is visible from the point, and 0 if nothing of it is. The lamp must have shadow maps. For
// the loops that run at most once, see directional_lights.glsl.
float lamp_visibility(Light light, vec3 position, vec3 normal) {
    float visible = 1.0;
    for (bool sharp = light.type < kLightCapsule; sharp; sharp = false)
        visible = sharp_visibility(light, position, normal);
    for (bool soft = light.type >= kLightCapsule; soft; soft = false) {
        const LampSight sight = see_from_lamp(light, position - light.position, normal, 3.0);
        visible = soft_visibility(sight, lamp_shape(light, sight.view, sight.p, sight.texels));
    }
    return visible;
}
#endif
