// Follows a ray through the depth image. A straight ray is also straight in the picture, and its reversed depth is a
// linear function of the place in the picture, as is 1 / distance. The depth pyramid (Hi-Z) lets the ray skip squares
// in which it is in front of all surfaces, or behind all of them. Ports: depth, hiz of graphs/modules/hiz.json.
//
// The march is exact: it tests every pixel in which the ray could meet a surface. So with and without the pyramid, a
// ray hits the same pixel.
#ifndef WEFT_MARCH
#define WEFT_MARCH
#include "frame_set.glsl"

uniform sampler2D depth;
uniform sampler2D hiz;

const int kLastLevel = 7;       // Level 0 is the depth image, level k is mip k − 1 of the pyramid.
const float kNudge_px = 1e-3;   // The ray goes this far beyond the edge of a square, to be in the next one.
const float kLeastRun_px = 1.0; // Shorter rays in the picture hit nothing.
const float kFarthest = 1e-30;  // Smallest depth of a point of a ray.

// A line in the picture: place in pixels (xy) and depth (z) = start + s · step. s = t / (w + t · w_step), where t is the
// distance along the ray in metres.
struct Line {
    vec3 start, step;
    float w, w_step, end;
};

struct Hit {
    bool found;
    ivec2 pixel;
    float s;
    float free;    // The ray is in front of all surfaces from 0 to this s.
    // How far the ray is behind the surface, as a share of the thickness, at its place in the pixel that is nearest to the
    // eye.
    float behind;
};

// The plane of the surface from which the ray starts: the depth at the pixel `at` is z + slope · (at − middle).
struct Plane {
    vec2 middle, slope;
    float z;
};

Line line_of(vec3 origin, vec3 direction, vec2 size) {
    const vec4 from = view.view_projection * vec4(origin, 1.0), along = view.view_projection * vec4(direction, 0.0);
    const vec3 ndc = from.xyz / from.w, step = (along.xyz - ndc * along.w) * vec3(0.5 * size, 1.0);
    const vec3 start = vec3((ndc.xy * 0.5 + 0.5) * size, ndc.z);
    float end = along.w > 0.0 ? 1.0 / along.w : 1e30;
    if (step.z > 0.0) end = min(end, (1.0 - start.z) / step.z);  // The near plane.
    const vec2 edges = mix(vec2(0.0), size, greaterThan(step.xy, vec2(0.0))) - start.xy;
    if (step.x != 0.0) end = min(end, edges.x / step.x);
    if (step.y != 0.0) end = min(end, edges.y / step.y);
    return Line(start, step, from.w, along.w, end);
}

float length_at(Line line, float s) { return s * line.w / max(1.0 - s * line.w_step, 1e-6); }

// Returns the nearest and the farthest depth in a square.
vec2 depths_in(ivec2 square, int level) {
    return level == 0 ? texelFetch(depth, square, 0).rr : texelFetch(hiz, square, level - 1).rg;
}

// Returns true if the pixel shows the plane from which the ray starts. A depth value is that of the middle of the pixel,
// so a ray along a steep plane could hit the plane itself.
bool shows_plane(Plane plane, ivec2 pixel, float z) {
    const float expected = plane.z + dot(plane.slope, vec2(pixel) + 0.5 - plane.middle);
    return abs(z - expected) < abs(plane.slope.x) + abs(plane.slope.y) + 1e-4 * plane.z;
}

// `thickness`: how far a surface extends behind the depth in the image, as a share of its distance. `most_level`: 0
// tests every pixel of the line. The ray hits nothing if it needs more than `most_steps` steps.
Hit march(Line line, Plane plane, float thickness, int most_level, uint most_steps) {
    Hit hit = Hit(false, ivec2(0), 0.0, line.end, 0.0);
    const float run_px = length(line.step.xy);
    if (run_px * line.end < kLeastRun_px) return hit;
    const vec2 inverse = 1.0 / mix(line.step.xy, vec2(1e-20), equal(line.step.xy, vec2(0.0)));
    const vec2 nudge = sign(line.step.xy) * kNudge_px;
    const float back = 1.0 / (1.0 + thickness);
    const ivec2 last = textureSize(depth, 0) - 1;
    int level = 0;
    float s = 0.0;
    for (uint i = 0u; i < most_steps && s < line.end; ++i) {
        const ivec2 square = clamp(ivec2(line.start.xy + line.step.xy * s + nudge), ivec2(0), last) >> level;
        const vec2 low = vec2(square << level);
        const vec2 edges = mix(low, low + float(1 << level), greaterThanEqual(line.step.xy, vec2(0.0)));
        const vec2 exits = (edges - line.start.xy) * inverse;
        const float exit = min(max(min(exits.x, exits.y), s), line.end);
        // The depth of the sky is 0. A point of the ray, also an infinitely distant one, is in front of the sky.
        const float z_in = max(line.start.z + line.step.z * s, kFarthest);
        const float z_out = max(line.start.z + line.step.z * exit, kFarthest);
        const vec2 surfaces = depths_in(square, level);
        const bool in_front = min(z_in, z_out) > surfaces.x;
        const bool passes = in_front || max(z_in, z_out) < surfaces.y * back;
        if (!passes && level > 0) {
            --level;
            continue;
        }
        if (!passes && !shows_plane(plane, square, surfaces.x)) {
            hit.found = true;
            hit.pixel = square;
            hit.behind = clamp((surfaces.x / max(z_in, z_out) - 1.0) / thickness, 0.0, 1.0);
            hit.free = min(hit.free, s);
            hit.s = line.step.z == 0.0 ? s : clamp((surfaces.x - line.start.z) / line.step.z, s, exit);
            return hit;
        }
        if (passes && !in_front) hit.free = min(hit.free, s);
        s = exit;
        if (passes) level = min(level + 1, most_level);
    }
    hit.free = min(hit.free, s);
    return hit;
}
#endif
