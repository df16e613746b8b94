// The light that a surface mirrors, from the reflection probes around a point. Units: cd/m², metres. The ports are
// optional, but only all together: `reflectionCubes`, `reflectionSh` and `reflectionMap` of
// graphs/modules/reflection_probes.json. If HAS_reflectionCubes is false, the functions must not be called.
//
// A cube shows what its probe sees. A point next to the probe sees the same surfaces in other directions. So a ray from
// the point is followed to the surface that it meets, and the cube is read in the direction from the probe to this
// place. Inside of a box, the ray ends at the box: Lagarde and Zanuttini 2012, "Local Image-based Lighting With
// Parallax-corrected Cubemap". Without a box, the ray ends at the surface that the distances in the cube describe:
// Szirmay-Kalos et al. 2005, "Approximate Ray-Tracing on the GPU with Distance Impostors".
#ifndef WEFT_REFLECTION_PROBES
#define WEFT_REFLECTION_PROBES
#include "environment_cube.glsl"
#include "screen_reflections.glsl"
#include "shared/probe_grid.glsl"
#include "shared/probe_sh.glsl"
#include "shared/reflection_box.glsl"

layout(constant_id = 29) const bool HAS_reflectionCubes = false;
layout(constant_id = 30) const bool HAS_reflectionSh = false;
layout(constant_id = 31) const bool HAS_reflectionMap = false;
// Radiance · kProbeRadianceScale. The mips are filtered for the same roughnesses as those of the cube in
// environment_cube.glsl. Alpha of mip 0: inverse distance from the probe in 1/m, 0 for the sky. The inverse distance is
// a linear function on a plane, so it can be interpolated.
uniform samplerCubeArray reflectionCubes;
layout(std430) readonly buffer ReflectionSh { vec4 items[]; } reflectionSh;  // As probeSh.
// For each probe: its position, and the rows of the matrix from world space to the space of its box. In this space, the
// box reaches from −1 to 1. A probe without a box has rows of 0.
layout(std430) readonly buffer ReflectionMap { vec4 items[]; } reflectionMap;

// The number of probes for which a test finds out whether they see the point. These are the probes with the largest
// weights, which depend on their distances and boxes.
const int kReflectionCandidates = 4;
// The weight of a probe with a box, relative to one without a box at a distance of 1 m.
const float kBoxWeight = 1000.0;
// Outside of its box, the weight of a probe falls to 0 over a distance of kBoxFade times half the size of the box. So a
// wall at which the box ends still gets the full weight.
const float kBoxFade = 0.1;
// A ray that meets no surface is followed up to this distance.
const float kFarReflection_m = 10000.0;
// The light of a probe has no weight if its distance is below this share of the distance for which nothing is in the
// way.
const float kLeastFree = 0.8;
// A surface that a probe sees is a wall of its box if its distance differs by less than this share from that of the
// wall.
const float kSameWall = 0.2;
// Assumed standard deviation of the inverse distance in a cube, divided by the inverse distance.
const float kReflectionDeviation = 0.03;

// The light of the probes around a point. share: 0 if no probe sees what the point mirrors, 1 if the probes give all of
// the light. sky: the part of the share for which the ray meets no surface. irradiance_over_pi: irradiance / π at the
// places of the probes, for a normal in the middle direction of the lobe.
struct ReflectionLight {
    vec3 radiance, irradiance_over_pi;
    float share, sky;
};

uint reflection_probe_count() { return uint(reflectionMap.items.length()) / kReflectionItems; }

vec3 reflection_place(uint probe) { return reflectionMap.items[probe * kReflectionItems].xyz; }

bool has_reflection_box(uint probe) { return reflectionMap.items[probe * kReflectionItems + 1u].xyz != vec3(0.0); }

vec3 to_reflection_box(uint probe, vec4 point) {
    const uint row = probe * kReflectionItems + 1u;
    return vec3(dot(reflectionMap.items[row], point), dot(reflectionMap.items[row + 1u], point),
                dot(reflectionMap.items[row + 2u], point));
}

// Returns in x the weight of a probe at a point, without the test whether the probe sees the point. Returns in y how
// far the point is inside of the box of the probe: 1 in the box or without a box, 0 far enough outside.
vec2 reflection_weight(uint probe, vec3 position) {
    const vec3 way = position - reflection_place(probe);
    const float near = 1.0 / (dot(way, way) + 0.25);
    if (!has_reflection_box(probe)) return vec2(near * near, 1.0);
    const vec3 at = abs(to_reflection_box(probe, vec4(position, 1.0)));
    const float inside = smoothstep(0.0, kBoxFade, 1.0 + kBoxFade - max(at.x, max(at.y, at.z)));
    return vec2(kBoxWeight * inside, inside);
}

float reflection_inverse_distance(uint probe, vec3 direction) {
    return textureLod(reflectionCubes, vec4(direction, float(probe)), 0.0).a;
}

// Returns how well a probe sees a point at `way` from it: 1 if nothing is between them, nearly 0 behind a surface.
float reflection_visibility(uint probe, vec3 way) {
    const float seen = reflection_inverse_distance(probe, way);
    const float behind = seen - inversesqrt(max(dot(way, way), 1e-6));
    if (behind <= 0.0) return 1.0;
    const float variance = kReflectionDeviation * kReflectionDeviation * seen * seen;
    const float chebyshev = variance / (variance + behind * behind);
    return chebyshev * chebyshev * chebyshev;
}

// Returns the distance along a ray to the sphere around the probe with this inverse radius. `from`: from the probe to
// the origin of the ray.
float distance_to_sphere(vec3 from, vec3 direction, float inverse_radius) {
    const float radius = 1.0 / max(inverse_radius, 1.0 / kFarReflection_m);
    const float b = dot(from, direction), c = dot(from, from) - radius * radius;
    return max(sqrt(max(b * b - c, 0.0)) - b, 0.0);
}

// Follows a ray to the surface that it meets. Returns the vector from the probe to this place or, if the ray meets no
// surface, `direction`. `agreement`: 1 if the probe sees the place, 0 if another surface hides it from the probe, or
// if the ray meets no surface, but the probe sees one in its direction. The function g = distance from the probe ·
// inverse distance in the cube − 1 is below 0 in front of the surface, 0 on it, and linear along the ray if the surface
// is a plane. So the secant method finds the root of g.
vec3 followed_reflection(uint probe, vec3 from, vec3 direction, out float agreement) {
    agreement = 1.0;
    float before = distance_to_sphere(from, direction, reflection_inverse_distance(probe, direction));
    vec3 place = from + direction * before;
    float inverse = reflection_inverse_distance(probe, place);
    float g_before = length(place) * inverse - 1.0;
    float at = distance_to_sphere(from, direction, inverse), g = 0.0;
    for (int i = 0; i < 3; ++i) {
        place = from + direction * at;
        inverse = reflection_inverse_distance(probe, place);
        if (inverse * kFarReflection_m < 1.0) {
            agreement = reflection_inverse_distance(probe, direction) * kFarReflection_m < 1.0 ? 1.0 : 0.0;
            return direction;
        }
        g = length(place) * inverse - 1.0;
        const float rise = g - g_before;
        if (i == 2 || abs(rise) < 1e-6) break;
        const float next = clamp(at - g * (at - before) / rise, 0.0, kFarReflection_m);
        before = at;
        g_before = g;
        at = next;
    }
    // Between the silhouette of an object and what is behind it, the interpolated distances are those of no surface. So
    // one of the four texels must have about the distance of the place.
    const vec4 off = abs(textureGather(reflectionCubes, vec4(place, float(probe)), 3) * length(place) - 1.0);
    agreement = 1.0 - smoothstep(0.1, 0.3, min(min(off.x, off.y), min(off.z, off.w)));
    return place;
}

// Returns the vector from the probe to the place at which a ray from inside of the box of the probe ends.
vec3 boxed_reflection(uint probe, vec3 position, vec3 direction) {
    const vec3 from = to_reflection_box(probe, vec4(position, 1.0)), along = to_reflection_box(probe, vec4(direction, 0.0));
    const vec3 ends = (mix(vec3(-1.0), vec3(1.0), greaterThanEqual(along, vec3(0.0))) - from) /
                      mix(along, vec3(1e-9), equal(along, vec3(0.0)));
    const float end = max(min(ends.x, min(ends.y, ends.z)), 0.0);
    return position + direction * end - reflection_place(probe);
}

// Adds the light of one probe with a weight. `direction` is the middle of the lobe. With screen
// reflections, only surfaces count that are farther than `free_m`, and that the picture does not show.
void add_reflection(inout ReflectionLight sum, uint probe, vec3 position, vec3 direction, float roughness, float free_m,
                    float weight) {
    const vec3 from = position - reflection_place(probe);
    float agreement = 1.0;
    const bool boxed = has_reflection_box(probe);
    vec3 way = boxed ? boxed_reflection(probe, position, direction) : direction;
    // The probe sees a wall of its box, or an object inside, or the sky.
    const bool is_wall = boxed && abs(reflection_inverse_distance(probe, way) * length(way) - 1.0) < kSameWall;
    if (!is_wall) way = followed_reflection(probe, from, direction, agreement);
    if (HAS_ssr && way != direction) {
        agreement *= smoothstep(kLeastFree, 1.0, distance(way, from) / max(free_m, 1e-6));
        agreement *= 1.0 - shown_in_picture(reflection_place(probe) + way);
    }
    // If the surface is nearer to the point than to the probe, the lobe is narrower as seen from the probe.
    const float nearer = clamp(distance(way, from) / max(length(way), 1e-4), 0.0, 1.0);
    const float blur = way == direction ? roughness : mix(roughness * nearer, roughness, roughness);
    const float lod = min(lod_of_roughness(blur), kLastFiltered), w = weight * agreement;
    sum.radiance += w / kProbeRadianceScale * textureLod(reflectionCubes, vec4(way, float(probe)), lod).rgb;
    const float basis[9] = harmonic_basis(direction);
    vec3 irradiance = vec3(0.0);
    for (uint i = 0u; i < 9u; ++i) irradiance += reflectionSh.items[probe * kProbeShStride + i].rgb * basis[i];
    sum.irradiance_over_pi += w * max(irradiance, vec3(0.0));
    sum.share += w;
    if (way == direction) sum.sky += w;
}

// The best probes by weight, from the largest to the smallest weight.
struct ReflectionCandidates {
    uint probes[kReflectionCandidates];
    vec2 weights[kReflectionCandidates];
};

ReflectionCandidates reflection_candidates(vec3 position) {
    ReflectionCandidates best;
    for (int i = 0; i < kReflectionCandidates; ++i) {
        best.probes[i] = 0u;
        best.weights[i] = vec2(0.0);
    }
    const uint count = reflection_probe_count();
    [[dont_unroll]] for (uint probe = 0u; probe < count; ++probe) {
        uint moved = probe;
        vec2 weight = reflection_weight(probe, position);
        if (reflectionSh.items[probe * kProbeShStride].w == 0.0) weight.x = 0.0;  // Not lit yet.
        for (int i = 0; i < kReflectionCandidates; ++i) {
            if (weight.x <= best.weights[i].x) continue;
            const uint probe_below = best.probes[i];
            const vec2 weight_below = best.weights[i];
            best.probes[i] = moved;
            best.weights[i] = weight;
            moved = probe_below;
            weight = weight_below;
        }
    }
    return best;
}

// Returns the light that a surface with this roughness mirrors. `direction` is the middle of the directions from which
// the surface mirrors light. The light is that of the two probes with the largest weights. The third largest weight is
// subtracted from the weights of both, so that the weight of a probe has fallen to 0 before another probe replaces it.
ReflectionLight reflection_light(vec3 position, vec3 direction, float roughness, float free_m) {
    const ReflectionCandidates best = reflection_candidates(position);
    ReflectionLight sum = ReflectionLight(vec3(0.0), vec3(0.0), 0.0, 0.0);
    float weights[kReflectionCandidates];
    float all = 0.0, inside = 0.0, first = 0.0, second = 0.0, third = 0.0;
    for (int i = 0; i < kReflectionCandidates; ++i) {
        weights[i] = 0.0;
        if (best.weights[i].x <= 0.0) continue;
        const float visible = reflection_visibility(best.probes[i], position - reflection_place(best.probes[i]));
        weights[i] = best.weights[i].x * visible;
        all += weights[i];
        inside = max(inside, best.weights[i].y * visible);
        third = max(third, min(second, weights[i]));
        second = max(second, min(first, weights[i]));
        first = max(first, weights[i]);
    }
    if (all <= 0.0) return sum;
    float used = 0.0;
    for (int i = 0; i < kReflectionCandidates; ++i) {
        const float weight = weights[i] - third;
        if (weight <= 0.0) continue;
        used += weight;
        add_reflection(sum, best.probes[i], position, direction, roughness, free_m, weight);
    }
    if (sum.share <= 0.0) return sum;
    const float scale = 1.0 / sum.share;
    return ReflectionLight(sum.radiance * scale, sum.irradiance_over_pi * scale, inside * sum.share / used, sum.sky * scale);
}
#endif
