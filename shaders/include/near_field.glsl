// The near field at a pixel: how much light from farther away arrives between near objects, and the light of these
// objects. Optional port of graphs/modules/near_field.json: `nearField`. A shader that defines WEFT_WITHOUT_NEAR_FIELD has
// no such port, and so one sampled image less: many devices allow 16 in a stage.
#ifndef WEFT_NEAR_FIELD
#define WEFT_NEAR_FIELD
#include "frame_set.glsl"
#include "octahedral.glsl"

#ifdef WEFT_WITHOUT_NEAR_FIELD
const bool HAS_nearField = false;
#else
layout(constant_id = 33) const bool HAS_nearField = false;
// Layer 0: irradiance / π × preExposure from near objects (rgb) and the visibility of the light from farther away (a).
// Layer 1: mean direction of the light from farther away (xy, octahedral) and distance to the eye in metres (z).
uniform sampler2DArray nearField;
#endif

struct NearField {
    vec3 open;         // Mean direction of the light from farther away.
    vec3 light;        // Irradiance / π from near objects, in cd/m².
    float visibility;  // Share of the irradiance of a uniform sky that arrives.
};

// Smallest weight of a texel that shows another surface. The weight is above 0, so that a surface that no texel shows
// still gets a result, from the texels of other surfaces.
const float kLeastAlike = 1e-4;
// Limits of the roughness. Up to kSmooth, near objects do not change the mirrored light. From kRough on, they change it
// fully.
const float kSmooth = 0.1, kRough = 0.3;

#ifdef WEFT_WITHOUT_NEAR_FIELD
NearField near_field_at(ivec2 pixel, vec3 position, vec3 n) { return NearField(n, vec3(0.0), 1.0); }
#else
// Returns the near field at a pixel, from the four texels around the pixel. A texel has less weight if its point is not
// in the plane of the surface. If the point is as far from the plane as a pixel is wide, the weight is a quarter.
NearField near_field_at(ivec2 pixel, vec3 position, vec3 n) {
    const ivec2 size = ivec2(view.viewport_px), last = textureSize(nearField, 0).xy - 1;
    const int side = (size.x + last.x) / (last.x + 1);  // Pixels of a texel.
    const ivec2 low = pixel / side;
    const vec2 share = vec2(pixel - low * side) / float(side);
    const float pixel_m = length(position - view.eye) * 2.0 / (view.projection[0][0] * view.viewport_px.x);
    vec3 open = vec3(0.0);
    vec4 light = vec4(0.0);
    float weights = 0.0;
    for (int i = 0; i < 4; ++i) {
        const ivec2 at = min(low + ivec2(i & 1, i >> 1), last);
        const vec4 shape = texelFetch(nearField, ivec3(at, 1), 0);
        if (shape.z <= 0.0) continue;  // The sky.
        const vec2 uv = (vec2(at * side) + 0.5) * view.inverse_viewport;
        const float off = dot(view.eye + ray_direction(uv) * shape.z - position, n) / pixel_m;
        const vec2 close = mix(1.0 - share, share, vec2(i & 1, i >> 1));
        const float alike = 1.0 / (1.0 + off * off);
        const float weight = max(close.x * close.y, 1e-3) * max(alike * alike, kLeastAlike);
        open += weight * octahedral_decode(shape.xy);
        light += weight * texelFetch(nearField, ivec3(at, 0), 0);
        weights += weight;
    }
    if (weights <= 0.0) return NearField(n, vec3(0.0), 1.0);
    return NearField(normalize(open + 1e-4 * n), light.rgb / (weights * frame.pre_exposure), light.a / weights);
}
#endif

// Returns the solid angle that two cones share, over 2π. `a`, `b`: cosines of half their opening angles; `apart`: angle
// between their axes. An approximation: Oat and Sander 2007, "Ambient Aperture Lighting".
float shared_cone(float a, float b, float apart) {
    const float angle_a = acos(a), angle_b = acos(b);
    const float largest = 1.0 - max(a, b), inside = abs(angle_a - angle_b), outside = angle_a + angle_b;
    return largest * (1.0 - smoothstep(inside, max(outside, inside + 1e-4), apart));
}

// Returns the share of the mirrored light that near objects do not block. The directions that are not blocked are
// treated as a cone around their mean direction, and the mirrored directions as another cone: Jimenez et al. 2016,
// "Practical Realtime Strategies for Accurate Indirect Occlusion". The part of the mirrored cone behind the surface
// itself is left out. Only the mean light of the near objects is known, which gives no sharp reflection. So for smooth
// surfaces the result is 1, and the reflection comes from the reflection probes.
float near_specular_visibility(NearField near, vec3 n, vec3 mirrored, float roughness) {
    if (roughness <= kSmooth) return 1.0;
    const float cone = exp2(-3.32193 * roughness * roughness);
    const float open = sqrt(max(1.0 - near.visibility, 0.0));
    const float seen = shared_cone(open, cone, acos(clamp(dot(near.open, mirrored), -1.0, 1.0)));
    const float whole = shared_cone(0.0, cone, acos(clamp(dot(n, mirrored), -1.0, 1.0)));
    return mix(1.0, clamp(seen / max(whole, 1e-4), 0.0, 1.0), smoothstep(kSmooth, kRough, roughness));
}
#endif
