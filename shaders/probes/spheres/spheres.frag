// Draws a sphere at a probe. With LIGHT, it looks like a white matt ball in the light of the probe. Otherwise its colour
// tells the level of the grid, as in the picture of `weft scene`: blue, green, yellow, red from fine to coarse. A black
// ring: the probe was moved. Grey: the probe was not baked yet. Dark lower half: the probe has no light yet. Magenta:
// in this direction the probe sees the inside of an object.
#version 460
#include "cube_texels.glsl"
#include "environment_cube.glsl"
#include "frame_set.glsl"
#include "shared/probe_grid.glsl"
#include "shared/probe_sh.glsl"
#include "srgb.glsl"

layout(constant_id = 0) const bool LIGHT = false;

layout(location = 0) in vec3 on_square;
layout(location = 1) flat in vec4 sphere;
layout(location = 2) flat in uint probe;

layout(location = 0) out vec4 color;

layout(std430) readonly buffer Points { ProbePoint items[]; } probePoints;
layout(std430) readonly buffer Grid { ProbeGrid items[]; } probeGrid;
layout(std430) readonly buffer Light { vec4 items[]; } probeSh;
uniform sampler2DArray probeMoments, probeDistance;

const vec3 kLevelTints[4] = vec3[](vec3(0.25, 0.55, 1.0), vec3(0.3, 0.85, 0.4), vec3(0.95, 0.85, 0.25), vec3(1.0, 0.35, 0.25));

vec3 level_tint(float spacing_m, ProbeGrid grid) {
    uint level = 0u;
    while (level + 1u < grid.levels && float(grid.strides[level / 4u][level % 4u]) * grid.spacing_m < 0.99 * spacing_m) ++level;
    return kLevelTints[min(level, 3u)];
}

bool is_moved(vec3 position, ProbeGrid grid) {
    const vec3 at = along_turned_grid(position - grid.origin, grid.half_yaw_tangent) / grid.spacing_m;
    return any(greaterThan(abs(at - round(at)), vec3(1e-3)));
}

bool sees_inside(vec3 direction) {
    vec2 at;
    const uint face = face_of_direction(direction, at);
    const int size = textureSize(probeDistance, 0).x;
    const ivec2 texel = min(ivec2((at * 0.5 + 0.5) * float(size)), size - 1);
    return texelFetch(probeDistance, ivec3(texel, 6u * probe + face), 0).r < 0.0;
}

vec3 state_color(vec3 n) {
    const ProbePoint point = probePoints.items[probe];
    const ProbeGrid grid = probeGrid.items[0];
    if (texelFetch(probeMoments, ivec3(0, 0, probe), 0).a < 0.0) return vec3(0.45);
    if (sees_inside(n)) return vec3(1.0, 0.1, 0.9);
    if (is_moved(point.position, grid) && abs(n.y) < 0.2) return vec3(0.0);
    const bool lit = probeSh.items[kProbeShStride * probe].w > 0.0;
    return level_tint(point.spacing_m, grid) * (lit || n.y > 0.0 ? 1.0 : 0.2);
}

vec3 light_color(vec3 n) {
    const float basis[9] = harmonic_basis(n);
    vec3 light = vec3(0.0);
    for (uint i = 0u; i < 9u; ++i) light += basis[i] * probeSh.items[kProbeShStride * probe + i].rgb;
    return srgb_encode(filmic(max(light, vec3(0.0)) * frame.pre_exposure));
}

void main() {
    const vec3 ray = normalize(on_square - view.eye), from_center = view.eye - sphere.xyz;
    const float middle_m = -dot(from_center, ray);
    const vec3 nearest = from_center + middle_m * ray;
    const float half_m2 = sphere.w * sphere.w - dot(nearest, nearest);
    if (half_m2 < 0.0 || middle_m * middle_m < half_m2) discard;
    const vec3 hit = view.eye + (middle_m - sqrt(half_m2)) * ray, n = (hit - sphere.xyz) / sphere.w;
    const vec4 clip = view.view_projection * vec4(hit, 1.0);
    gl_FragDepth = clip.z / clip.w;
    color = vec4(LIGHT ? light_color(n) : state_color(n) * (0.45 + 0.55 * dot(n, -ray)), 1.0);
}
