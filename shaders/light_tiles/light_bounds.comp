// Computes, once per frame, the region in view space that each light reaches, so that tiles need not compute it again.
// Input: lights.
// Output: lightBounds, described in light_bounds.glsl. The texels of directional lights are not written.
#version 460
#include "frame_set.glsl"
#include "pixel_box.glsl"
#include "lights.glsl"
#include "reach.glsl"
#include "light_bounds.glsl"

layout(local_size_x = 64) in;

readonly buffer Lights { Light items[]; } lights;
layout(rgba32f) writeonly uniform image2D lightBounds;

// Twice the largest relative rounding error of the transformation from world space to view space. The transformation
// adds four products, and each may be wrong by half a unit in the last place.
const float kTransformError = 1e-6;

float sum_of_sizes(vec3 v) { return abs(v.x) + abs(v.y) + abs(v.z); }

Reach reach_of(Light light) {
    const mat3 turn = mat3(view.view);
    Reach r;
    r.center = (view.view * vec4(light.position, 1.0)).xyz;
    r.slack_m = kTransformError * (sum_of_sizes(light.position) + sum_of_sizes(view.view[3].xyz)) +
                kPlaceError * sum_of_sizes(r.center);
    r.range_m = light.range_m > 0.0 ? light.range_m * (1.0 + kPlaceError) + r.slack_m : kEndless;
    r.direction = turn * light.direction;
    r.first = r.second = vec3(0.0);
    r.cos_spread = -1.0;
    if (light.type == kLightSpot) r.cos_spread = clamp(cone_edge(light) - kPlaceError, -1.0, 1.0);
    if (light.type == kLightCapsule) r.first = r.direction * light.half_size_m.x;
    if (light.type == kLightRectangle) {
        const vec3 side = turn * light.side;
        r.first = side * light.half_size_m.x;
        r.second = cross(side, r.direction) * light.half_size_m.y;
        r.cos_spread = 0.0;
    }
    r.sin_spread = sqrt(1.0 - r.cos_spread * r.cos_spread);
    return r;
}

// Returns a sphere around the region that the light reaches. If the edge of a cone is less than 45° from the axis, the
// sphere passes through the tip and the rim. From 45° to 90°, the rim is the equator of the sphere.
vec4 sphere_around(Reach r) {
    const float core_m = length(r.first) + length(r.second) + r.slack_m;
    if (r.cos_spread <= 0.0 || r.range_m >= kEndless) return vec4(r.center, core_m + r.range_m);
    const bool narrow = r.cos_spread > r.sin_spread;
    const float radius_m = narrow ? r.range_m / (2.0 * r.cos_spread) : r.range_m * r.sin_spread;
    const float ahead_m = narrow ? radius_m : r.range_m * r.cos_spread;
    return vec4(r.center + r.direction * ahead_m, (radius_m + core_m) * (1.0 + kPlaceError));
}

void main() {
    const uint light = gl_GlobalInvocationID.x;
    if (light < frame.directional_count || light >= min(frame.light_count, uint(lights.items.length()))) return;
    const Reach r = reach_of(lights.items[light]);
    const ivec2 at = bounds_texel(light);
    imageStore(lightBounds, at, sphere_around(r));
    imageStore(lightBounds, at + ivec2(0, 1), vec4(r.center, r.range_m));
    imageStore(lightBounds, at + ivec2(0, 2), vec4(r.first, r.cos_spread));
    imageStore(lightBounds, at + ivec2(0, 3), vec4(r.second, r.slack_m));
    imageStore(lightBounds, at + ivec2(0, 4), vec4(r.direction, r.sin_spread));
}
