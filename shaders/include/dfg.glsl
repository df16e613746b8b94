// Directional albedo of the specular reflection. If equal light comes from all directions, a surface reflects the share
// F0 · scale + F90 · bias of this light by single reflections at its microfacets (GGX, height-correlated Smith,
// Schlick). The port `dfg` is the table of graphs/modules/dfg.json. Without the port, a fitted function replaces the
// table. A factor on the reflection adds the light that microfacets reflect several times: Turquin 2019, "Practical
// multiple scattering compensation for microfacet models".
#ifndef WEFT_DFG
#define WEFT_DFG
#include "brdf.glsl"
#include "dfg_table.glsl"

layout(constant_id = 22) const bool HAS_dfg = false;
layout(std430) readonly buffer Dfg { uvec2 items[]; } dfg;

// Returns an element of the table, from the four nearest ones. The cosine is stored as its square root, because the values
// change fastest at grazing angles. The first and the last element are for the values 0 and 1.
vec3 dfg_at(float roughness, float nv) {
    const vec2 at = clamp(vec2(sqrt(nv), roughness), 0.0, 1.0) * float(kDfgSide - 1u);
    const uvec2 first = min(uvec2(at), uvec2(kDfgSide - 2u));
    const vec2 share = at - vec2(first);
    const uint i = first.y * kDfgSide + first.x;
    const vec3 near = mix(unpacked_dfg(dfg.items[i]), unpacked_dfg(dfg.items[i + 1u]), share.x);
    const vec3 next =
        mix(unpacked_dfg(dfg.items[i + kDfgSide]), unpacked_dfg(dfg.items[i + kDfgSide + 1u]), share.x);
    return mix(near, next, share.y);
}

// Returns scale and bias. Their sum, and the bias divided by (1 − n·v)⁵, are polynomials of z = n·v / (n·v + 0.8 α) and
// of the roughness r. The polynomials were fitted to the integrals on a grid of 50 × 41 values, with weights that were
// adapted until the largest error was smallest (Lawson 1961). Largest errors for n·v from 0.02 to 1 and all
// roughnesses: 0.0097 (scale), 0.0055 (bias).
vec2 fitted_dfg(float r, float nv) {
    const float z = nv / (nv + max(0.8 * r * r, 1e-4));
    const float sum = ((((-3.4414 * z + (2.2524 * r + 6.8158)) * z + ((-3.5227 * r - 1.5134) * r - 4.1366)) * z +
                        (((-1.2944 * r + 6.0755) * r - 0.8517) * r + 0.8963)) * z +
                       ((((6.2847 * r - 14.9971) * r + 9.6382) * r - 3.4336) * r + 0.2304)) * z +
                      (((((5.0420 * r - 16.5380) * r + 20.5265) * r - 12.0993) * r + 3.3992) * r + 0.6384);
    const float share = (((-1.9475 * z + (1.7266 * r + 4.9068)) * z + ((1.8278 * r + 0.4979) * r - 4.1132)) * z +
                         (((3.1845 * r - 5.2391) * r + 1.0551) * r + 1.2085)) * z +
                        ((((-0.1640 * r - 1.0294) * r + 3.1969) * r - 2.9090) * r + 0.9390);
    const float away = 1.0 - nv, away2 = away * away;
    const float bias = clamp(share * away2 * away2 * away, 0.0, 1.0);
    return vec2(max(min(sum, 1.0) - bias, 0.0), bias);
}

// Returns the surface with the factors for its specular reflection towards `v`. If F0 = F90 = 1 and equal light comes
// from all directions, the surface reflects all of this light.
Surface with_albedo(Surface s, vec3 v) {
    const float roughness = sqrt(sqrt(s.alphas.x * s.alphas.y));
    const float nv = clamp(dot(s.normal, v), 0.0, 1.0);
    float several = 1.0;
    if (HAS_dfg) {
        const vec3 element = dfg_at(roughness, nv);
        s.albedo = element.xy;
        several = element.z;
    } else {
        s.albedo = fitted_dfg(roughness, nv);
    }
    s.energy = 1.0 + several * s.f0 * (1.0 / (s.albedo.x + s.albedo.y) - 1.0);
    return s;
}
#endif
