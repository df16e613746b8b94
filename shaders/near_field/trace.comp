// Finds the objects near each surface point in the depth image: how much light from farther away they block, from which
// directions light arrives, and the light that they themselves reflect to the point (from the picture of the previous
// frame). Works on every `nearScale`-th pixel of each row and column. Objects that the picture does not show are missing.
//
// Output nearTraced: rgb: irradiance / π from near objects × preExposure; a: visibility, the share of the irradiance of
// a uniform sky that arrives. Output nearBent: xyz: mean direction of this light, of length 0 to 1; w: distance to the
// eye in metres, 0 for the sky. An object whose earlier picture is unknown blocks nothing, because its light is not known.
#version 460
#include "frame_set.glsl"
#include "octahedral.glsl"
#include "probes.glsl"
#include "slice.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

uniform sampler2D depth;
uniform sampler2D normal;
uniform sampler2D velocity;
uniform sampler2D nearSource;
layout(rgba16f) writeonly uniform image2D nearTraced;
layout(rgba16f) writeonly uniform image2D nearBent;

layout(push_constant) uniform Params {
    float nearSourceValid;  // 1 if a frame has written nearSource, otherwise 0.
    float nearRadius;       // Largest distance of an object from the surface point, in metres.
    float nearThickness;    // How far an object extends behind its visible surface, as a share of the radius.
    uint nearScale;
    uint nearSlices;        // Number of slices of each point.
    uint nearSteps;         // Number of places that are read on each side of a slice.
    uint nearNoise;         // 1: directions and places differ from pixel to pixel and from frame to frame.
} params;

// Each slice has a different radius, so that the effect of an object ends gradually with the distance. The radius is
// shortened by a random share, at most this number.
const float kRandomRadius = 0.4;
// Smallest cosine of the angle between the normal and the direction to the eye that follow() uses to move points into
// the slice.
const float kLeastFacing = 0.1;
// Two neighbouring places on one side of a slice belong to the same object if the distance between them is at most
// kJoined times d. d is the distance that the two pixels would have on a plane perpendicular to the view. If the places
// belong to the same object, this object also fills the angles between them.
const float kJoined = 4.0;
// Length of the mean direction of uniform light from the whole hemisphere, weighted by the cosine.
const float kUniform = 2.0 / 3.0;
// Steps of evenly distributed (low-discrepancy) sequences.
const float kGolden = 0.61803399, kPlastic = 0.75487767;

struct Point {
    ivec2 pixel;
    vec3 position, normal, to_eye;
    float radius_m;
};

struct Gathered {
    vec3 light, direction;
    float visible, whole;
};

vec3 point_at(ivec2 pixel, float z) {
    return world_position((vec2(pixel) + 0.5) / vec2(textureSize(depth, 0)), z);
}

// Returns the distance between the probes around a point, at most nearRadius.
float probe_distance_m(vec3 position) {
    const vec3 grid = probe_grid_place(position);
    const uint levels = probeMap.items[1].x;
    for (uint level = 0u; level < levels; ++level) {
        const float stride = float(probe_stride(level));
        if (find_probe_cell(ivec3(floor(grid / stride)) * int(stride), level) != kNoItem)
            return min(stride * probe_grid_spacing_m(), params.nearRadius);
    }
    return params.nearRadius;
}

// Returns the radius around a point: the distance between the probes there, because light from farther away comes from
// the probes. The distance is that of a random place nearby, so that the mean radius changes gradually where probes with
// other distances begin.
float near_radius_m(vec3 position, vec2 noise) {
    if (!HAS_probeMap) return params.nearRadius;
    const float distance_m = probe_distance_m(position);
    if (params.nearNoise == 0u) return distance_m;
    const vec3 aside = fract(vec3(noise, kGolden * 8.0 * noise.x + kPlastic * 8.0 * noise.y)) - 0.5;
    return probe_distance_m(position + distance_m * aside);
}

// Returns the radiance × preExposure of the surface at a pixel in the previous frame (rgb), and 1 if it is known (a).
vec4 light_before(ivec2 pixel) {
    const vec2 size = vec2(textureSize(depth, 0));
    const vec2 from = (vec2(pixel) + 0.5) / size - texelFetch(velocity, pixel, 0).xy;
    if (params.nearSourceValid <= 0.0 || any(lessThan(from, vec2(0.0))) || any(greaterThan(from, vec2(1.0))))
        return vec4(0.0);
    // A texel covers nearScale pixels, and the last one may reach beyond the picture.
    const vec2 covered = vec2(textureSize(nearSource, 0)) * float(params.nearScale);
    const vec3 color = textureLod(nearSource, from * size / covered, 0.0).rgb;
    return vec4(color * (frame.pre_exposure / frame.prev_pre_exposure), 1.0);
}

// Two numbers from 0 to 1 for the pixel, evenly distributed over 4 × 4 texels and over the frames.
vec2 noise_of(ivec2 texel) {
    if (params.nearNoise == 0u) return vec2(0.0, 0.5);
    const vec2 pattern = vec2((((texel.x + texel.y) & 3) << 2) + (texel.x & 3), ((texel.y - texel.x) & 3) * 4) / 16.0;
    return fract(pattern + vec2(kGolden, kPlastic) * float(frame.frame_index % 1024u));
}

// Marks the sectors `found` as blocked by an object with the radiance `light`: adds the light of the object to `sum`,
// and subtracts the light of the sky in these sectors.
void hide(inout Gathered sum, Slice slice, uint found, vec3 light) {
    while (found != 0u) {
        const uint begin = uint(findLSB(found)), rest = ~(found >> begin);
        const uint end = rest == 0u ? 32u : min(begin + uint(findLSB(rest)), 32u);
        const SliceLight part = light_of_sectors(slice, begin, end);
        sum.light += part.measure * light;
        sum.visible -= part.measure;
        sum.direction -= part.direction.x * slice.to_eye + part.direction.y * slice.across;
        found &= ~bits_between(begin, end);
    }
}

// Follows one side of a slice through the picture, and adds the light of near objects to `sum`. `step_px`: offset in
// the picture, in pixels, of one metre along `across`. The bits of `hidden` are the sectors that an object already
// blocks.
void follow(inout Gathered sum, inout uint hidden, Point p, Slice slice, float side, vec2 step_px, float radius_m, vec2 noise) {
    const vec2 size = vec2(textureSize(depth, 0));
    const vec3 sideways = cross(slice.to_eye, slice.across);
    // The direction in the plane of the surface that leads out of the slice. Pixels are not exactly in the slice: the
    // loop moves their points along this direction into the slice.
    const vec3 leaving =
        sideways - slice.to_eye * (dot(sideways, p.normal) / max(dot(slice.to_eye, p.normal), kLeastFacing));
    const float reach_px = min(length(step_px) * radius_m, length(size));
    const vec2 along = side * normalize(step_px);
    const uint steps = uint(clamp(ceil(reach_px), 1.0, float(params.nearSteps)));
    // Position of the previous point. The next two variables are its distance in pixels and its place in sectors.
    vec3 last = vec3(0.0);
    float last_px = -1.0, last_sector = 0.0;
    for (uint i = 0u; i < steps; ++i) {
        const float t = (float(i) + noise.y) / float(steps);
        const float away_px = 1.0 + t * t * max(reach_px - 1.0, 0.0);
        const vec2 at = vec2(p.pixel) + 0.5 + along * away_px;
        if (any(lessThan(at, vec2(0.0))) || any(greaterThanEqual(at, size))) break;
        const ivec2 pixel = ivec2(at);
        const float z = texelFetch(depth, pixel, 0).r;
        if (z <= 0.0) continue;
        const vec3 place = point_at(pixel, z);
        const vec3 apart = place - p.position, front = apart - leaving * dot(apart, sideways);
        const float distance_m = length(front);
        if (distance_m > radius_m || distance_m <= 0.0) continue;
        const vec3 back = front + normalize(place - view.eye) * (params.nearThickness * radius_m);
        const float a = sector_of(slice, front / distance_m, side), b = sector_of(slice, normalize(back), side);
        const float gap_m = (away_px - last_px) / length(step_px);
        const bool joined = last_px >= 0.0 && distance(place, last) < kJoined * gap_m;
        const float c = joined ? last_sector : a;
        last = place;
        last_px = away_px;
        last_sector = a;
        const uint found = sectors_between(min(min(a, b), c), max(max(a, b), c), noise.x) & ~hidden;
        if (found == 0u) continue;
        const vec4 light = light_before(pixel);
        if (light.a <= 0.0) continue;
        hidden |= found;
        hide(sum, slice, found, light.rgb);
    }
}

Gathered gather(Point p, vec2 noise) {
    const vec2 size = vec2(textureSize(depth, 0));
    const vec3 aside = normalize(cross(p.to_eye, abs(p.to_eye.y) < 0.9 ? vec3(0, 1, 0) : vec3(1, 0, 0)));
    const vec3 up = cross(aside, p.to_eye);
    const vec4 clip = view.view_projection * vec4(p.position, 1.0);
    Gathered sum = Gathered(vec3(0.0), vec3(0.0), 0.0, 0.0);
    for (uint i = 0u; i < params.nearSlices; ++i) {
        const float turn = kPi * (float(i) + noise.x) / float(params.nearSlices);
        const Slice slice = make_slice(p.to_eye, cos(turn) * aside + sin(turn) * up, p.normal);
        const vec4 moved = view.view_projection * vec4(slice.across, 0.0);
        const vec2 step_px = 0.5 * size * (moved.xy - clip.xy / clip.w * moved.w) / clip.w;
        const vec2 random = fract(noise + float(i) * vec2(kPlastic, kGolden));
        const float radius_m = p.radius_m * (params.nearNoise == 0u ? 1.0 : 1.0 - kRandomRadius * random.x);
        sum.whole += light_of_sectors(slice, 0u, kSectors).measure;
        uint hidden = 0u;
        follow(sum, hidden, p, slice, -1.0, step_px, radius_m, random);
        follow(sum, hidden, p, slice, 1.0, step_px, radius_m, random);
    }
    sum.visible += sum.whole;
    sum.direction += kUniform * sum.whole * p.normal;
    return sum;
}

void main() {
    const ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(texel, imageSize(nearTraced)))) return;
    const ivec2 pixel = min(texel * int(params.nearScale), textureSize(depth, 0) - 1);
    const float z = texelFetch(depth, pixel, 0).r;
    vec4 traced = vec4(0.0, 0.0, 0.0, 1.0), bent = vec4(0.0);
    if (z > 0.0) {
        const vec3 position = point_at(pixel, z), n = octahedral_decode(texelFetch(normal, pixel, 0).xy);
        const float distance_m = distance(position, view.eye);
        const vec2 noise = noise_of(texel);
        const Point p = Point(pixel, position, n, (view.eye - position) / distance_m, near_radius_m(position, noise));
        const Gathered sum = gather(p, noise);
        const float scale = sum.whole > 0.0 ? 1.0 / sum.whole : 0.0;
        traced = vec4(min(sum.light * scale, vec3(65000.0)), clamp(sum.visible * scale, 0.0, 1.0));
        const vec3 open = sum.direction * scale + 1e-4 * n;
        bent = vec4(open, distance_m);
    }
    imageStore(nearTraced, texel, traced);
    imageStore(nearBent, texel, bent);
}
