// Temporal anti-aliasing: blends this frame, whose sample positions are jittered, with the history of the same
// surfaces. Output: scene-linear × preExposure; alpha is the number of blended frames, at most 256. It is negative where
// the object moves by itself, and not only with the camera.
//
// Sources: Karis 2014, "High-Quality Temporal Supersampling", for the velocity of the nearest neighbour, blending of
// compressed colours, and YCoCg. Salvi 2016, "An Excursion in Temporal Supersampling", for clipping the history to a
// box around the mean, whose size is a multiple of the standard deviation.
#version 460
#include "frame_set.glsl"
#include "half_float.glsl"
#include "catmull_rom.glsl"
#include "compressed_color.glsl"
#include "shared/light_change.glsl"

const uint kTileSide = 8u;
layout(local_size_x = kTileSide, local_size_y = kTileSide) in;

uniform sampler2D hdr;
uniform sampler2D before;
uniform sampler2D velocity;
uniform sampler2D depth;
layout(std430) readonly buffer LightChanges { LightChange items[]; } lightChanges;
layout(rgba16f) writeonly uniform image2D resolved;

layout(push_constant) uniform Params {
    float beforeValid;  // 1 if a frame has written `before`, otherwise 0.
    float newest;       // Smallest weight of this frame where the picture moves, 0 to 1.
    float newestStill;  // Smallest weight of this frame where the picture stands still, 0 to 1.
    float trust;        // Distance from the middle of the clipping box to its sides, in standard deviations.
} params;

// The clipping box of a still pixel is larger by this factor, so that a thin wire or a small highlight that only some
// frames hit is kept. A pixel that moves by kMovingPx or more has the normal box.
const float kTrustInStillness = 16.0, kMovingPx = 0.125;
const float kStillPx = 0.01;  // Movements below this length (in pixels) are rounding errors.
// The largest rounding error of a half float in a compressed colour. The deviation of the neighbours is at least this
// large: the clipping box would have no width in a channel that is the same for all neighbours, and the history of the
// other channels would be lost, too.
const float kRounding = 0.25 / 2048.0;
// A pixel has become brighter or darker if log2(now / history) is far from 0; from kChange on, it counts as a whole
// pixel. The light of a tile of 8 × 8 pixels has changed if many more pixels have become brighter than darker, or the
// reverse. If the difference is at most kLeastShare of all pixels, the light has not changed. From kMostShare on, the
// history is useless. The jitter changes only the pixels at edges, and some of them become brighter and others darker.
const float kChange = 0.3, kLeastShare = 0.45, kMostShare = 0.65;
// After this number of frames, the mean contains each of the usual 16 positions of the jitter twice, and a still
// picture is finished.
const float kSettled = 32.0;
// Values below kBlack count as black. The unit is white in the final picture.
const float kBlack = 1e-3;
const float kPi = 3.14159265;
const float kLeastDistance2 = 1e-4;  // Square of the smallest distance of a lamp from a surface, in m².

// The lights of a frame may change a share of the light of a pixel. From kLeastLag on, the newest frame counts as where
// the picture moves; from an eighth of kLeastLag on, the history is clipped as there. A lamp steps if its illuminance
// changes by most of its size in one frame, for example if it goes off. If steps change more than the share kLeastStep,
// less of the history counts, and from kMostStep on none of it. The surface is assumed to reflect kReflected of the light.
const float kLeastLag = 0.02, kLeastStep = 0.01, kMostStep = 0.03, kReflected = 0.5;

shared float changes[kTileSide * kTileSide], row_sums[kTileSide];

struct Neighbours {
    vec3 mean;
    vec3 deviation;
    ivec2 nearest;  // The neighbour whose surface is nearest to the eye.
    float depth;    // Depth of the pixel `nearest` (reversed).
};

float luma_of(vec3 color) { return dot(color, vec3(0.25, 0.5, 0.25)); }

Neighbours neighbours_of(ivec2 pixel) {
    const ivec2 last = textureSize(hdr, 0) - 1;
    Neighbours n = Neighbours(vec3(0.0), vec3(0.0), pixel, texelFetch(depth, pixel, 0).r);
    for (int i = 0; i < 9; ++i) {
        const ivec2 at = clamp(pixel + ivec2(i % 3, i / 3) - 1, ivec2(0), last);
        const vec3 color = compressed(texelFetch(hdr, at, 0).rgb);
        n.mean += color / 9.0;
        n.deviation += color * color / 9.0;
        const float z = texelFetch(depth, at, 0).r;
        if (z > n.depth) {
            n.depth = z;
            n.nearest = at;
        }
    }
    n.deviation = sqrt(max(n.deviation - n.mean * n.mean, vec3(kRounding * kRounding)));
    return n;
}

// Returns the movement, in uv, that a still point at `uv` has only because the camera moves. `point`: its place (w = 1)
// or its direction (w = 0) in world space.
vec2 moved_by_camera(vec4 point, vec2 uv) {
    const vec4 clip = view.prev_view_projection * point;
    return uv - view.jitter_uv - (clip.xy / clip.w * 0.5 + 0.5);
}

// Returns the movement of the pixel's content since the previous frame, in uv. The movement of the sky follows only
// from the rotation of the camera.
vec2 moved(Neighbours n, vec2 uv) {
    if (n.depth > 0.0) return texelFetch(velocity, n.nearest, 0).xy;
    return moved_by_camera(vec4(ray_direction(uv), 0.0), uv);
}

// Returns true if the object moves by itself. Then its motion differs from that of a still point at the same place.
bool moves_by_itself(Neighbours n, vec2 motion, vec2 size) {
    if (n.depth <= 0.0) return false;
    const vec2 uv = (vec2(n.nearest) + 0.5) / size;
    const vec2 still = moved_by_camera(vec4(world_position(uv, n.depth), 1.0), uv);
    return length((motion - still) * size) > kMovingPx;
}

// Moves a colour outside the box to the point where the line from the colour to the middle enters the box. The box
// extends from middle − reach to middle + reach.
vec3 clipped(vec3 color, vec3 middle, vec3 reach) {
    const vec3 away = color - middle;
    const vec3 beyond = abs(away) / max(reach, vec3(1e-5));
    return middle + away / max(1.0, max(beyond.x, max(beyond.y, beyond.z)));
}

// Returns the share of the pixels of the tile that have become brighter since the history was written, minus the share of
// those that have become darker, without its sign. `ratio`: log2(now / history) of the pixel. All invocations of the
// workgroup must call this.
float changed_share(float ratio, bool counts) {
    const uint own = gl_LocalInvocationIndex;
    changes[own] = counts ? clamp(ratio / kChange, -1.0, 1.0) : 0.0;
    barrier();
    if (own < kTileSide) {
        float sum = 0.0;
        for (uint i = 0u; i < kTileSide; ++i) sum += changes[own * kTileSide + i];
        row_sums[own] = sum;
    }
    barrier();
    float sum = 0.0;
    for (uint i = 0u; i < kTileSide; ++i) sum += row_sums[i];
    return abs(sum) / float(kTileSide * kTileSide);
}

// Changes of the radiance at a point, if the surface faced all lights that changed, in cd/m².
struct RadianceChange {
    float all;
    float steps;  // Of the lights that step.
};

RadianceChange change_of_radiance(vec3 position) {
    float all = 0.0, steps = 0.0;
    for (uint i = 0u; i < kMostLightChanges; ++i) {
        const LightChange change = lightChanges.items[i];
        if (change.intensity_before + change.intensity <= 0.0) break;
        const vec3 before = change.position_before - position, after = change.position - position;
        const float old = change.intensity_before / max(dot(before, before), kLeastDistance2);
        const float now = change.intensity / max(dot(after, after), kLeastDistance2);
        all += now - old;
        steps += abs(now - old) * smoothstep(0.3, 0.6, abs(now - old) / max(now, old));
    }
    return RadianceChange(kReflected / kPi * abs(all), kReflected / kPi * steps);
}

void main() {
    const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy), size = imageSize(resolved);
    const vec2 uv = (vec2(pixel) + 0.5) / vec2(size);
    const bool drawn = all(lessThan(pixel, size));
    const vec3 linear = texelFetch(hdr, min(pixel, size - 1), 0).rgb, now = compressed(linear);
    const Neighbours around = neighbours_of(min(pixel, size - 1));
    const vec2 motion = moved(around, uv), from = uv - motion;
    const float motion_px = length(motion * vec2(size));
    const vec4 seen = motion_px < kStillPx ? texelFetch(before, min(pixel, size - 1), 0) : catmull_rom(before, from);
    const bool inside = all(greaterThanEqual(from, vec2(0.0))) && all(lessThan(from, vec2(1.0)));
    const bool was_there = params.beforeValid > 0.0 && inside;

    const vec3 old = max(seen.rgb, vec3(0.0)) * (frame.pre_exposure / frame.prev_pre_exposure);
    const float ratio = log2((luma_of(linear) + kBlack) / (luma_of(old) + kBlack));
    const float pixels = changed_share(ratio, was_there && drawn);
    if (!drawn) return;
    // Where an object stood that moves by itself, another surface appears. This surface has no history yet.
    const bool own = moves_by_itself(around, motion, vec2(size));
    const float history = texelFetch(before, clamp(ivec2(from * vec2(size)), ivec2(0), size - 1), 0).a;
    const bool appears = own != (history < 0.0);
    float changed = appears ? 1.0 : smoothstep(kLeastShare, kMostShare, pixels), moving = clamp(motion_px, 0.0, 1.0);
    if (around.depth > 0.0) {
        const RadianceChange change = change_of_radiance(world_position(uv, around.depth));
        const float one_cd = frame.pre_exposure / max(luma_of(linear), kBlack);  // 1 cd/m² as a share of the light.
        changed = max(changed, smoothstep(kLeastStep, kMostStep, change.steps * one_cd));
        moving = max(moving, min(change.all * one_cd / kLeastLag, 1.0));
    }
    moving = max(moving, changed);
    const float trust = params.trust * mix(kTrustInStillness, 1.0, min(moving / kMovingPx, 1.0));
    const vec3 believed = clipped(compressed(old), around.mean, around.deviation * trust);
    const float count = was_there ? abs(history) * (1.0 - changed) : 0.0;
    const float newest = mix(params.newestStill, params.newest, moving);
    const float settling = count < kSettled ? 1.0 / (count + 1.0) : 0.0;
    const float weight = was_there ? max(settling, newest) : 1.0;
    const vec3 color = expanded(mix(believed, now, weight));
    const float blended = min(count + 1.0, 256.0);
    imageStore(resolved, pixel, vec4(nearest_half(clamp(color, 0.0, 65000.0)), own ? -blended : blended));
}
