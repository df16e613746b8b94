// Debug views of the light of the probes on the surfaces that the camera sees. probeIrradiance: irradiance / π ×
// preExposure. probeWeights: each probe has a colour, and a point has the mean colour of the probes whose light it gets,
// by their weights. probeVisibility: 1 if all probes of the cell see the point, 0 if none does. The last two views show
// the finest cell around a point, without the fading between levels. Points outside of all cells are black.
#version 460
#include "debug_colors.glsl"
#include "frame_set.glsl"
#include "probes.glsl"

layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 probeIrradiance;
layout(location = 1) out vec4 probeWeights;
layout(location = 2) out float probeVisibility;

uniform sampler2D depth;

// Adds up the probes of the cell: rgb is the sum of the colours times the weights, w is the sum of the weights. `all`
// receives the sum of the weights without the test whether the probe sees the point.
vec4 weighted_colors(ProbeQuery q, uint cell, vec3 t, float spacing_m, out float all) {
    vec4 sum = vec4(0.0);
    all = 0.0;
    for (uint corner = 0u; corner < 8u; ++corner) {
        const ProbeCorner found = probe_corner(q, cell, corner, t, spacing_m);
        all += found.weight;
        if (found.lit) sum += found.weight * found.visible * vec4(index_color(found.probe + 1u), 1.0);
    }
    return sum;
}

void main() {
    probeIrradiance = probeWeights = vec4(0.0, 0.0, 0.0, 1.0);
    probeVisibility = 0.0;
    const float z = texelFetch(depth, ivec2(gl_FragCoord.xy), 0).r;
    const vec3 position = world_position(uv, max(z, 1e-6));
    const vec3 normal = normalize(cross(dFdy(position), dFdx(position)));
    if (z <= 0.0) return;
    const vec3 to_eye = normalize(view.eye - position);
    const vec4 light = probe_irradiance_over_pi(position, normal, to_eye);
    probeIrradiance.rgb = light.rgb * (light.a * frame.pre_exposure);
    const ProbeQuery q = ProbeQuery(position, normal, to_eye, harmonic_basis(normal), harmonic_basis(normal), vec3(0.0));
    const vec3 grid = probe_grid_place(position);
    for (uint level = 0u; level < probeMap.items[1].x; ++level) {
        const float stride = float(probe_stride(level));
        vec3 t;
        float share, all;
        const uint cell = probe_cell_at(grid / stride, level, level + 1u == probeMap.items[1].x, t, share);
        if (cell == kNoItem || share <= 0.0) continue;
        const vec4 sum = weighted_colors(q, cell, t, stride * probe_grid_spacing_m(), all);
        probeWeights.rgb = sum.rgb / max(sum.w, 1e-20);
        probeVisibility = sum.w / max(all, 1e-20);
        return;
    }
}
