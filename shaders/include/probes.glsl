// The diffuse light of the irradiance probes around a point. Units: cd/m². The ports are optional, but only all
// together: `probeSh` (light of the probes), `probeMoments` (what blocks the view of the probes) and `probeMap` (where
// they stand). If HAS_probeSh is false, there are no probes, and the functions must not be called.
//
// A point gets the light of the eight probes at the corners of the finest cell around it. The weight of a probe is the
// product of three factors: the place of the point in the cell (trilinear), the side of the surface on which the probe
// is, and whether the probe sees the point. Sources: Majercik et al. 2019, "Dynamic Diffuse Global Illumination with
// Ray-Traced Irradiance Fields", and 2021, "Scaling Probe-Based Real-Time Dynamic Global Illumination for Production".
// Both papers test with two moments of the distance whether a probe sees a point. Here the test uses the plane of the
// surface that the probe sees in a direction, and the deviation of the surface from this plane. So walls seen at
// grazing angles need no tolerance.
#ifndef WEFT_PROBES
#define WEFT_PROBES
#include "environment_cube.glsl"
#include "octahedral.glsl"
#include "probe_map.glsl"
#include "shared/probe_sh.glsl"

layout(constant_id = 26) const bool HAS_probeSh = false;
layout(constant_id = 27) const bool HAS_probeMoments = false;
layout(constant_id = 28) const bool HAS_probeMap = false;
layout(std430) readonly buffer ProbeSh { vec4 items[]; } probeSh;
// One layer for each probe: an octahedral map with a border of one texel; see probes/moments.comp. rgb: the plane that
// the probe sees, or 0 for the sky. A point is on the plane if dot(rgb, vector from the probe to the point) = 1. a: how
// much the surface deviates from the plane, as the standard deviation of the inverse distance.
uniform sampler2DArray probeMoments;
layout(std430) readonly buffer ProbeMap { uvec4 items[]; } probeMap;

const uint kNoItem = 0xffffffffu;

// Next to a place without a cell of the same level, the light of the cell changes gradually to the light of the next
// coarser level. This happens over this share of the width of the cell.
const float kProbeFade = 0.25;
// Outside of the coarsest cells, the light of these cells fades to 0 over this distance. Unit: the distance between two
// neighbouring probes of this level.
const float kProbeReach = 0.5;
// Before the test whether a probe sees the point, the point moves along the normal by kProbeBias times the spacing, the
// distance between neighbouring probes. It also moves towards the eye by the same distance. So a surface does not hide
// itself. For spacings above kMostBiasSpacing_m, the distance of this move stays the same.
const float kProbeBias = 0.1, kMostBiasSpacing_m = 1.0;
// After the test whether the probes of a cell see the point, a share of the weights of these probes is left. If this
// share is at least kProbeTrust, the cell counts fully.
const float kProbeTrust = 0.02;
// Smallest trilinear factor along an axis. So even a point at one side of the cell gets light from the probes at the
// opposite side, if the probes at its own side are missing or do not see the point.
const float kLeastCloseness = 0.01;
// A surface faces to one side along an axis if the component of its normal along this axis is at least this large.
const float kFacingAxis = 0.25;
// A texel of the map of a probe hides points fully if its weight in a linear filter is at least 1 / kTexelHides.
const float kTexelHides = 32.0;
// Limits for the soft shadow of an object between a probe and a point. The edge is soft only if both conditions hold.
// First, the point is much farther from the probe than the object: at kLeastEdge times the distance the edge is still
// sharp, at kMostEdge times it is soft. Second, beside the object, the probe sees a surface near the point. This is
// measured by the difference between the inverse distances of this surface and of the point, divided by the inverse
// distance of the point: up to kLeastOff the edge is soft, from kMostOff on it is sharp.
const float kLeastEdge = 1.6, kMostEdge = 3.0;
const float kLeastOff = 0.4, kMostOff = 0.7;
// Limits of the standard deviation of the inverse distance, as shares of the inverse distance. The upper limit prevents
// light leaks where a texel shows a rough or a curved surface.
const float kLeastDeviation = 0.03, kMostDeviation = 0.12;

// The light of the probes. facing, mirrored: irradiance / π for two directions. validity: 0 if no
// probe gives light, 1 if the probes give all of it. outside: 1 if no cell is near the point, 0 in a cell.
struct ProbeLight {
    vec3 facing, mirrored;
    float validity;
    float outside;
};

// The data of a point that a lookup needs.
struct ProbeQuery {
    vec3 position, normal, to_eye;
    float facing_basis[9], mirrored_basis[9];
    // To find what hides the point, a probe looks beside the point. The offset is this vector times the distance.
    vec3 aside;
};

// Returns a way in world space along the axes of the grid.
vec3 along_probe_grid(vec3 way) { return along_turned_grid(way, uintBitsToFloat(probeMap.items[1].w)); }
// Returns the way from the origin of the grid to a point, along the axes of the grid, in spacings of the finest level.
vec3 probe_grid_place(vec3 position) {
    const vec4 grid = uintBitsToFloat(probeMap.items[0]);
    return along_probe_grid(position - grid.xyz) / grid.w;
}
float probe_grid_spacing_m() { return uintBitsToFloat(probeMap.items[0].w); }
uint probe_stride(uint level) { return probeMap.items[2u + level / 4u][level % 4u]; }

// Returns the first item of a cell, or kNoItem. `at` is the corner of the cell with the smallest coordinates.
uint find_probe_cell(ivec3 at, uint level) {
    const uvec3 sizes = probeMap.items[1].xyz;  // Numbers of levels, of slots in the table of cells, and of probes.
    const uint begin = first_cell_item(sizes.z);
    uint slot = probe_cell_slot(at, level, sizes.y);
    for (uint tried = 0u; tried < sizes.y; ++tried) {
        const uint item = begin + kProbeCellItems * slot;
        const uvec4 key = probeMap.items[item];
        if (key.w == kEmptyProbeSlot) return kNoItem;
        if (key == uvec4(at, level)) return item;
        slot = (slot + 1u) & (sizes.y - 1u);
    }
    return kNoItem;
}

// Returns 0 next to a place without a cell of the same level, and 1 at a distance of kProbeFade cells. `t`: place in the
// cell, from 0 to 1. `neighbours` has one set bit for each existing cell around the cell. Only the neighbours at the
// nearer sides are tested, because all others are too far away.
float probe_cell_share(uint neighbours, vec3 t) {
    const ivec3 side = ivec3(greaterThanEqual(t, vec3(0.5))) * 2 - 1;
    const vec3 away = min(t, 1.0 - t);
    float nearest = kProbeFade;
    for (int i = 1; i < 8; ++i) {
        const ivec3 part = ivec3(i, i >> 1, i >> 2) & 1, at = part * side + 1;
        const bool exists = (neighbours >> (at.x + 3 * at.y + 9 * at.z) & 1u) != 0u;
        const vec3 apart = vec3(part) * away;
        if (!exists) nearest = min(nearest, max(apart.x, max(apart.y, apart.z)));
    }
    return smoothstep(0.0, 1.0, nearest / kProbeFade);
}

// Returns how well a probe sees a point: 1 if nothing is between them, nearly 0 for a point behind a surface. Each of
// the four nearest texels of the map has a plane. Where two walls meet in a corner, the texel that hides most decides:
// the nearer wall hides the point. A texel far from the direction hides less, so that the result is continuous. There
// is one exception: where the probe sees a surface near the point beside the edge of a nearer object, such as a column,
// the mean of the texels decides. Otherwise the edge would look like a sharp shadow, as if the probe were a lamp.
float probe_visibility(uint probe, vec3 to_point, vec3 aside) {
    const vec2 at = (octahedral_encode(to_point + length(to_point) * aside) * 0.5 + 0.5) * float(kProbeMomentSide) + 0.5;
    const vec2 low = floor(at), high_share = at - low;
    const float distance = length(to_point);
    // Of each of the four texels: the inverse distance of its surface, and the deviation of this distance. Both are
    // divided by the inverse distance of the point.
    vec4 surfaces, deviations;
    for (int i = 0; i < 4; ++i) {
        const vec4 seen = texelFetch(probeMoments, ivec3(ivec2(low) + ivec2(i & 1, i >> 1), int(probe)), 0);
        surfaces[i] = dot(seen.xyz, to_point);
        deviations[i] = seen.w * distance;
    }
    const float nearest = max(max(surfaces.x, surfaces.y), max(surfaces.z, surfaces.w));
    if (nearest <= 1.0) return 1.0;  // Most points are in front of all four surfaces.
    const float farthest = min(min(surfaces.x, surfaces.y), min(surfaces.z, surfaces.w));
    const vec4 weights = vec4(1.0 - high_share.x, high_share.x, 1.0 - high_share.x, high_share.x) *
                         vec4(1.0 - high_share.y, 1.0 - high_share.y, high_share.y, high_share.y);
    const vec4 deviation = clamp(deviations, kLeastDeviation * surfaces, kMostDeviation * surfaces);
    const vec4 variance = max(deviation * deviation, vec4(1e-12));
    const vec4 behind = max(surfaces - 1.0, vec4(0.0)), less_behind = behind * min(kTexelHides * weights, vec4(1.0));
    const vec4 hides = variance / (variance + less_behind * less_behind), sees = variance / (variance + behind * behind);
    const float least = min(min(hides.x, hides.y), min(hides.z, hides.w));
    const float edge =
        smoothstep(kLeastEdge, kMostEdge, nearest) * (1.0 - smoothstep(kLeastOff, kMostOff, abs(farthest - 1.0)));
    return mix(least * least * least, dot(weights, sees * sees * sees), edge);
}

// A probe at a corner of a cell, as a point sees it.
struct ProbeCorner {
    uint probe;       // kNoProbe: there is no probe at the corner.
    // Depends on the place of the point in the cell, and on the side of the surface on which the probe is.
    float weight;
    float visible;    // How well the probe sees the point.
    bool lit;         // False: the probe has no light yet.
};

ProbeCorner probe_corner(ProbeQuery q, uint cell, uint corner, vec3 t, float spacing_m) {
    ProbeCorner found = ProbeCorner(probeMap.items[cell + 1u + corner / 4u][corner % 4u], 0.0, 1.0, false);
    if (found.probe == kNoProbe) return found;
    const vec3 place = uintBitsToFloat(probeMap.items[kProbeGridItems + found.probe].xyz);
    const vec3 close = max(mix(1.0 - t, t, vec3(uvec3(corner, corner >> 1, corner >> 2) & 1u)), kLeastCloseness);
    const vec3 to_probe = place - q.position;
    const float cosine = dot(to_probe, q.normal) * inversesqrt(max(dot(to_probe, to_probe), 1e-12));
    const float wrapped = 0.5 + 0.5 * cosine;
    found.weight = close.x * close.y * close.z * (wrapped * wrapped + 0.2);
    found.lit = probeSh.items[kProbeShStride * found.probe].w > 0.0;
    if (!found.lit) return found;
    const vec3 seen_at = q.position + (q.normal + q.to_eye) * (kProbeBias * min(spacing_m, kMostBiasSpacing_m));
    // The visibility is never 0. So if the point is hidden from all probes, the probes that hide it least give the
    // light.
    found.visible = max(probe_visibility(found.probe, seen_at - place, q.aside), 1e-12);
    return found;
}

// Sums over cells: irradiance / π for both directions, the share of probes that have light, and the weights.
struct ProbeSum {
    vec3 facing, mirrored;
    float lit, weight;
};

// Adds the light of the probes of a cell, with the weight `share`. Returns how well these probes see the point, from 0
// to 1, or −1 if the cell has no probe. If the probes hardly see the point, the cell counts little, so that a coarser
// cell whose probes see the point decides. `t`: place of the point in the cell.
float add_probe_cell(inout ProbeSum sum, ProbeQuery q, uint cell, vec3 t, float spacing_m, float share) {
    vec3 facing = vec3(0.0), mirrored = vec3(0.0);
    float lit = 0.0, all = 0.0, weights = 0.0;
    [[dont_unroll]] for (uint corner = 0u; corner < 8u; ++corner) {
        const ProbeCorner found = probe_corner(q, cell, corner, t, spacing_m);
        const float visible = found.weight * found.visible;
        all += visible;
        weights += found.weight;
        if (!found.lit) continue;
        lit += visible;
        const uint first = kProbeShStride * found.probe;
        for (uint i = 0u; i < 9u; ++i) {
            const vec3 coefficient = probeSh.items[first + i].rgb;
            facing += visible * q.facing_basis[i] * coefficient;
            mirrored += visible * q.mirrored_basis[i] * coefficient;
        }
    }
    if (weights <= 0.0) return -1.0;
    const float trust = clamp(all / (weights * kProbeTrust), 1e-6, 1.0);
    const float scale = share * trust / all;
    sum.facing += scale * max(facing, vec3(0.0));
    sum.mirrored += scale * max(mirrored, vec3(0.0));
    sum.lit += scale * lit;
    sum.weight += share * trust;
    return trust;
}

// Finds the cell of a level. Points that are at most kProbeReach spacings away from a cell of the coarsest level use
// the nearest of these cells. `grid`: the point in spacings of the level. `t` becomes the place in the cell. `share`
// becomes the weight of the cell.
uint probe_cell_at(vec3 grid, uint level, bool coarsest, out vec3 t, out float share) {
    const int stride = int(probe_stride(level));
    const vec3 corner = floor(grid);
    uint cell = find_probe_cell(ivec3(corner) * stride, level);
    t = grid - corner;
    share = 1.0;
    if (cell != kNoItem) {
        if (!coarsest) share = probe_cell_share(probeMap.items[cell + 3u].x, t);
        return cell;
    }
    if (!coarsest) return kNoItem;
    const ivec3 side = ivec3(greaterThanEqual(t, vec3(0.5))) * 2 - 1;
    const vec3 away = min(t, 1.0 - t), at = t;
    float nearest = kProbeReach;
    [[dont_unroll]] for (int i = 1; i < 8; ++i) {
        const ivec3 part = ivec3(i, i >> 1, i >> 2) & 1;
        const vec3 apart = vec3(part) * away;
        const float distance = max(apart.x, max(apart.y, apart.z));
        if (distance >= nearest) continue;
        const uint found = find_probe_cell((ivec3(corner) + part * side) * stride, level);
        if (found == kNoItem) continue;
        cell = found;
        nearest = distance;
        t = clamp(at - vec3(part * side), 0.0, 1.0);
    }
    share = 1.0 - nearest / kProbeReach;
    return cell;
}

// Adds the light of the cells around a cell, for a point that the probes of its own cell do not see: for example next to
// a thin wall, with all probes of the cell behind the wall. Along each axis, only the cells on one side count: the side
// to which the surface faces or, if it faces to neither side, the side nearer to the point. These are seven cells.
void add_cells_around(inout ProbeSum sum, ProbeQuery q, uint cell, vec3 t, float spacing_m, float share) {
    const uvec4 key = probeMap.items[cell];
    const uint neighbours = probeMap.items[cell + 3u].x;
    const int stride = int(probe_stride(key.w));
    const vec3 normal = along_probe_grid(q.normal);
    const vec3 towards = mix(t - 0.5, normal, greaterThan(abs(normal), vec3(kFacingAxis)));
    const ivec3 side = ivec3(greaterThanEqual(towards, vec3(0.0))) * 2 - 1;
    [[dont_unroll]] for (int i = 1; i < 8; ++i) {
        const ivec3 step = (ivec3(i, i >> 1, i >> 2) & 1) * side, bit = step + 1;
        if ((neighbours >> (bit.x + 3 * bit.y + 9 * bit.z) & 1u) == 0u) continue;
        const uint around = find_probe_cell(ivec3(key.xyz) + step * stride, key.w);
        add_probe_cell(sum, q, around, clamp(t - vec3(step), 0.0, 1.0), spacing_m, share);
    }
}

// Returns the light of the probes around a point. `n`: normal of the surface. `to_eye`: unit vector to the eye. `facing`,
// `mirrored`: the two directions for which the irradiance is wanted; `facing` is usually the normal. `aside`: see
// ProbeQuery.
ProbeLight probe_light(vec3 position, vec3 n, vec3 to_eye, vec3 facing, vec3 mirrored, vec3 aside) {
    const ProbeQuery q = ProbeQuery(position, n, to_eye, harmonic_basis(facing), harmonic_basis(mirrored), aside);
    const vec3 grid = probe_grid_place(position);
    const uint levels = probeMap.items[1].x;
    ProbeSum sum = ProbeSum(vec3(0.0), vec3(0.0), 0.0, 0.0);
    float rest = 1.0;     // Weight that is left for the coarser levels.
    float beyond = 1.0;   // The value that `rest` would have if all probes saw the point.
    float outside = 1.0;  // 0 in a cell, 1 if no cell is near.
    uint first_cell = kNoItem;
    vec3 first_t = vec3(0.0);
    [[dont_unroll]] for (uint level = 0u; level < levels && rest > 1e-3; ++level) {
        const float stride = float(probe_stride(level));
        const bool coarsest = level + 1u == levels;
        vec3 t;
        float share;
        const uint cell = probe_cell_at(grid / stride, level, coarsest, t, share);
        if (cell == kNoItem || share <= 0.0) continue;
        const float trust = add_probe_cell(sum, q, cell, t, stride * probe_grid_spacing_m(), rest * share);
        if (first_cell == kNoItem) {
            first_cell = cell;
            first_t = t;
        }
        rest *= 1.0 - share * max(trust, 0.0);
        beyond *= 1.0 - share;
        outside = coarsest ? outside * (1.0 - share) : 0.0;
    }
    if (rest - beyond > 1e-3)
        add_cells_around(sum, q, first_cell, first_t,
                         float(probe_stride(probeMap.items[first_cell].w)) * probe_grid_spacing_m(), rest - beyond);
    if (sum.lit <= 0.0) return ProbeLight(vec3(0.0), vec3(0.0), 0.0, outside);
    return ProbeLight(sum.facing / sum.lit, sum.mirrored / sum.lit, sum.lit / sum.weight * (1.0 - outside), outside);
}

// Returns irradiance / π of the probes (rgb) and their validity (a), from 0 to 1. Where the validity is below 1, mix
// with the light of the surroundings: mix(surroundings, result.rgb, result.a).
vec4 probe_irradiance_over_pi(vec3 position, vec3 n, vec3 to_eye) {
    const ProbeLight light = probe_light(position, n, to_eye, n, n, vec3(0.0));
    return vec4(light.facing, light.validity);
}
#endif
