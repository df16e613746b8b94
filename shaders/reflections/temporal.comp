// Blends the mirrored light with that of earlier frames. A mirrored object moves in the picture like an object behind
// the mirror, at the virtual point: the place as far behind the surface as the ray is long. On a rough surface, the
// blurred light moves like the surface. So the history is read at both places, and the value that is closer to the light
// of this frame is used.
// Output blended: layer 0: rgb: radiance × preExposure × confidence, a: confidence. Layer 1: xy: normal in octahedral
// encoding, z: distance to the eye in metres (0: the sky), w: number of blended frames, at most 30, plus the deviation
// of the light of single frames, below 1 (-1: the surface has no rays). Layer 2: as ssrOpen of filter.comp.
#version 460
#include "compressed_color.glsl"
#include "frame_set.glsl"
#include "half_float.glsl"
#include "octahedral.glsl"
#include "ray.glsl"
#include "tiles.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(std430) readonly buffer Tiles { uint items[]; } tiles;  // Those with a texel that reflects.
uniform sampler2D depth;
uniform sampler2D velocity;
uniform sampler2D ssrSurface;
uniform sampler2D ssrMean;
uniform sampler2D ssrReach;
uniform sampler2D ssrOpen;
uniform sampler2DArray before;
layout(rgba16f) writeonly uniform image2DArray blended;

layout(push_constant) uniform Params {
    float beforeValid;  // 1 if a frame has written the history, otherwise 0.
    float ssrNewest;    // Smallest weight of this frame in the mean over frames, 0 to 1.
    float ssrTrust;     // The history may differ from the mean of the neighbours by this many standard deviations.
    uint ssrScale;
    uint ssrNeighbours;
} params;

// The history is from the same surface if the distances to the eye differ by less than a share, and the cosine of the
// angle between the normals is larger than kSameNormal. The share is kSameDistance for the history at the place of the
// surface, and kNearDistance at the virtual point, which may be another point of the same surface.
const float kSameDistance = 0.05, kNearDistance = 0.25, kSameNormal = 0.9;
// The rays of a mirror have no noise, so the weight of a new frame is kNewestOfMirror. From the roughness kFullNoise on,
// it is ssrNewest.
const float kNewestOfMirror = 0.5, kFullNoise = 0.07;
// With a smaller mean confidence, the range of the colours around a texel is not known.
const float kFewHits = 0.1;
// From this multiple of the range on, the history counts as that of other light.
const float kOtherLight = 1.8;
// The count of frames and the deviation of their light are stored as one half float, whose steps are 1 / kSteps from a
// count of 16 on.
const float kMostFrames = 30.0, kSteps = 64.0;
// Largest growth of the light of a texel in one frame, from kSettled blended frames on.
const float kMostGrowth = 2.0, kSettled = 4.0;
// Radiance × preExposure that always is usual, so that black can become brighter.
const float kDark = 0.004;
// Shares of the deviation over frames by which the history may differ from the light around the texel in this frame: for
// the range into which the history is moved, and for the decision whether the mean begins again.
const float kMovedShare = 0.1, kBegunShare = 2.0;
// Smaller differences of compressed colours (xyz) and of the confidence (w) are not visible.
const vec4 kVisible = vec4(vec3(0.004), 0.05);

// Radiance × preExposure, compressed (xyz), and confidence (w).
struct Statistics {
    vec4 mean, deviation;
};

struct History {
    vec4 light, open;
    float count;
    float deviation;  // Of the compressed light of single frames at this place, before they were blended.
    float off;        // Difference to the light of this frame.
    bool valid;
};

// Light is stored multiplied by its confidence. Colours are compared without it, so that a doubtful hit is not dark.
vec4 compressed_light(vec4 light) { return vec4(compressed(max(light.rgb, vec3(0.0)) / max(light.a, 1e-4)), light.a); }

// Neighbouring texels share rays, so a single bright ray can fill 3 × 3 of them. Texels that share no ray tell whether
// the light has changed: `step_px` is the distance of the texels that are used.
Statistics statistics_of(ivec2 texel, int step_px) {
    const ivec2 last = textureSize(ssrMean, 0) - 1;
    vec4 sum = vec4(0.0), squares = vec4(0.0), weights = vec4(1e-6, 1e-6, 1e-6, 9.0);
    for (int i = 0; i < 9; ++i) {
        const ivec2 at = clamp(texel + (ivec2(i % 3, i / 3) - 1) * step_px, ivec2(0), last);
        const vec4 light = compressed_light(texelFetch(ssrMean, at, 0)), weight = vec4(light.aaa, 1.0);
        sum += weight * light;
        squares += weight * light * light;
        weights.xyz += light.a;
    }
    sum /= weights;
    return Statistics(sum, sqrt(max(squares / weights - sum * sum, kVisible * kVisible)));
}

// Moves the history into the range of the light around the texel in this frame. Returns radiance × preExposure ×
// confidence, and confidence. Sets `outside` to the distance of the history from the middle of this range, where 1 is
// the end of the range.
vec4 clipped(vec4 light, float deviation, Statistics around, out float outside) {
    const vec4 range = max(around.deviation, vec4(vec3(deviation), 0.0)) * params.ssrTrust;
    const vec4 away = light - around.mean, beyond = abs(away) / range;
    const float color_outside = max(beyond.x, max(beyond.y, beyond.z));
    // Without hits around the texel, the range of colours is not known.
    const float known = min(around.mean.a / kFewHits, 1.0);
    const vec3 color = mix(light.rgb, around.mean.rgb + away.rgb / max(1.0, color_outside), known);
    const float confidence = around.mean.a + away.a / max(1.0, beyond.a);
    outside = max(color_outside * min(light.a, around.mean.a), beyond.a);
    return vec4(expanded(color) * confidence, confidence);
}

// A single ray that meets a small bright object can be a hundred times as bright as the mean. Returns a factor for the
// blended light, so that it is at most kMostGrowth times the light before, or the light that most texels around have.
// `before_light`: with that of the surroundings.
float share_without_speck(vec3 blended_light, vec3 before_light, Statistics around) {
    // Of the luminance and the confidence, not of the differences of colour.
    const vec4 low = max(around.mean - around.deviation * vec4(1.0, 0.0, 0.0, 1.0), vec4(0.0, -1.0, -1.0, 0.0));
    const vec3 usual = max(max(before_light, expanded(low.rgb) * low.a), vec3(kDark));
    const float most = kMostGrowth * max(max(usual.r, usual.g), usual.b);
    return min(1.0, most / max(max(max(blended_light.r, blended_light.g), blended_light.b), 1e-6));
}

// Returns uv of a still point in the previous frame, plus the jitter of this frame: a texel of the history was moved by
// the jitter of its own frame, and the mean over all jitters is 0.
vec2 uv_before(vec3 place) {
    const vec4 clip = view.prev_view_projection * vec4(place, 1.0);
    return clip.xy / clip.w * 0.5 + 0.5 + view.jitter_uv;
}

History history_at(vec2 from, vec3 normal, float distance_m, float same, Statistics around) {
    History found = History(vec4(0.0), vec4(0.0), 0.0, 0.0, 1e9, false);
    const bool inside = all(greaterThanEqual(from, vec2(0.0))) && all(lessThan(from, vec2(1.0)));
    if (params.beforeValid <= 0.0 || !inside) return found;
    const vec2 covered = vec2(textureSize(ssrMean, 0)) * float(params.ssrScale);
    // A texel has the values of its first pixel.
    const vec2 at = (from * vec2(textureSize(depth, 0)) + 0.5 * float(params.ssrScale) - 0.5) / covered;
    const ivec2 size = textureSize(ssrMean, 0), nearest = min(ivec2(at * vec2(size)), size - 1);
    const vec4 shape = texelFetch(before, ivec3(nearest, 1), 0);
    const bool near = shape.w >= 0.0 && abs(shape.z - distance_m) <= same * distance_m;
    if (!near || dot(octahedral_decode(shape.xy), normal) < kSameNormal) return found;
    vec4 light = textureLod(before, vec3(at, 0.0), 0.0);
    const float exposed = frame.pre_exposure / frame.prev_pre_exposure;
    light.rgb *= exposed;
    found.light = compressed_light(light);
    found.count = floor(shape.w);
    found.deviation = shape.w - found.count;
    // Not interpolated: a texel whose rays all hit something has no value.
    found.open = texelFetch(before, ivec3(nearest, 2), 0) * vec4(1.0, vec3(exposed));
    const vec4 off = found.light - around.mean;
    found.off = dot(off, off);
    found.valid = true;
    return found;
}

struct Reflector {
    vec3 position, normal;
    float distance_m, depth;
};

// Returns the history at the place of the surface or at the virtual point. `reach_m`: mean length of the rays; 0: no hit.
History best_history(ivec2 pixel, vec2 uv, Reflector r, float reach_m, Statistics around) {
    // The velocities are those of opaque surfaces. A transparent surface in front of them is treated as if it stood still.
    const bool opaque = texelFetch(depth, pixel, 0).r == r.depth;
    const vec2 from = opaque ? uv - texelFetch(velocity, pixel, 0).xy : uv_before(r.position);
    const History own = history_at(from, r.normal, r.distance_m, kSameDistance, around);
    if (reach_m <= 0.0) return own;
    const vec3 virtual_point = view.eye + (r.position - view.eye) * ((r.distance_m + reach_m) / r.distance_m);
    const History mirrored = history_at(uv_before(virtual_point), r.normal, r.distance_m, kNearDistance, around);
    if (mirrored.valid && mirrored.off < own.off) return mirrored;
    return own;
}

// Returns the number that is stored for a count of frames and a deviation. The deviation is rounded up or down at random,
// so that it can change by less than a step.
float packed_history(ivec2 texel, float count, float deviation) {
    const float random = fract(52.9829189 * fract(dot(vec2(texel), vec2(0.06711056, 0.00583715))) +
                               0.61803399 * float(frame.frame_index & 1023u));
    return count + clamp(floor(deviation * kSteps + random), 0.0, kSteps - 1.0) / kSteps;
}

void store(ivec2 texel, vec4 light, vec4 shape, vec4 open) {
    imageStore(blended, ivec3(texel, 0), light);
    imageStore(blended, ivec3(texel, 1), shape);
    imageStore(blended, ivec3(texel, 2), open);
}

void main() {
    const uint at = place_in_list();
    if (at >= tiles.items[3]) return;
    const ivec2 size = imageSize(blended).xy;
    const ivec2 texel = texel_of_tile(tiles.items[kTilesBegin + at], size);
    if (any(greaterThanEqual(texel, size))) return;
    const vec4 surface = texelFetch(ssrSurface, texel, 0);
    if (surface.z <= 0.0) {
        store(texel, vec4(0.0), vec4(0.0), vec4(0.0));
        return;
    }
    const ivec2 pixel = min(texel * int(params.ssrScale), textureSize(depth, 0) - 1);
    const vec2 uv = (vec2(pixel) + 0.5) * view.inverse_viewport;
    const vec3 position = world_position(uv, surface.z), normal = octahedral_decode(surface.xy);
    const float distance_m = min(distance(position, view.eye), 65000.0);
    if (surface.w >= kNoRays) {
        store(texel, vec4(0.0), vec4(surface.xy, distance_m, -1.0), vec4(0.0));
        return;
    }
    vec4 open = texelFetch(ssrOpen, texel, 0);
    const int side = side_of_neighbours(surface.w, params.ssrNeighbours);
    const Statistics around = statistics_of(texel, 1);
    Statistics wide = around;
    if (side > 1) wide = statistics_of(texel, side);
    const Reflector r = Reflector(position, normal, distance_m, surface.z);
    const History best = best_history(pixel, uv, r, texelFetch(ssrReach, texel, 0).r, around);
    vec4 light = texelFetch(ssrMean, texel, 0);
    float count = 0.0, deviation = 0.0;
    if (best.valid) {
        float outside, widely_outside;
        const vec4 before_light = clipped(best.light, kMovedShare * best.deviation, around, outside);
        clipped(best.light, kBegunShare * best.deviation, wide, widely_outside);
        // Where the light has changed, the mean begins again.
        count = best.count * clamp(kOtherLight - min(outside, widely_outside), 0.0, 1.0);
        const float least = mix(kNewestOfMirror, params.ssrNewest, smoothstep(0.0, kFullNoise, surface.w));
        const float newest = max(1.0 / (count + 1.0), least);
        const vec3 change = compressed_light(light).rgb - best.light.rgb;
        deviation = sqrt(mix(best.deviation * best.deviation, dot(change, change) / 3.0, count > 0.0 ? newest : 0.0));
        const vec4 mean = mix(before_light, light, newest);
        const vec3 seen = mix(best.open.yzw, expanded(best.light.rgb), best.light.a);
        const float share = share_without_speck(mean.rgb, seen, wide);
        light = vec4(mean.rgb * mix(1.0, share, smoothstep(0.0, kSettled, count)), mean.a);
        if (best.open.x > 0.0 && count > 0.0) open = open.x > 0.0 ? mix(best.open, open, newest) : best.open;
    }
    // In the first frame, there is no previous picture, so nothing is mirrored. With the count 0, the next frame
    // replaces this result.
    count = params.beforeValid > 0.0 ? min(floor(count) + 1.0, kMostFrames) : 0.0;
    light.rgb = nearest_half(min(light.rgb, vec3(65000.0)));
    store(texel, light, vec4(surface.xy, distance_m, packed_history(texel, count, deviation)), open);
}
