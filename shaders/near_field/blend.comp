// Smooths the near field (the light and the shadow of near objects, from trace.comp) over neighbouring points of the
// same surface, and blends it with the near field of earlier frames.
// Output nearField: layer 0: the values of nearTraced, smoothed and blended. Layer 1: xy: mean direction of the light
// in octahedral encoding, z: distance to the eye in metres, w: number of blended frames, at most 256.
#version 460
#include "frame_set.glsl"
#include "half_float.glsl"
#include "octahedral.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

uniform sampler2D depth;
uniform sampler2D normal;
uniform sampler2D velocity;
uniform sampler2D nearTraced;
uniform sampler2D nearBent;
uniform sampler2DArray before;
layout(rgba16f) writeonly uniform image2DArray nearField;

layout(push_constant) uniform Params {
    float beforeValid;  // 1 if a frame has written the history, otherwise 0.
    float nearNewest;   // Smallest weight of this frame in the mean over frames, 0 to 1.
    uint nearScale;
    uint nearSmooth;    // 0: no smoothing over neighbours and frames.
} params;

// A neighbour belongs to the same surface if two conditions are met: its distance from the plane of the surface is
// below kPlaneShare times the distance to the eye, and the cosine of the angle between the normals is above
// kLeastCosine.
const float kPlaneShare = 0.005, kLeastCosine = 0.8;
// The history is from the same surface if the distances to the eye differ by less than this share of the distance.
const float kSameDistance = 0.05;

struct Smooth {
    vec4 light;
    vec3 bent;
};

vec3 place_of(ivec2 texel, float distance_m) {
    const vec2 uv = (vec2(texel * int(params.nearScale)) + 0.5) / vec2(textureSize(depth, 0));
    return view.eye + ray_direction(uv) * distance_m;
}

vec3 normal_of(ivec2 texel) {
    const ivec2 pixel = min(texel * int(params.nearScale), textureSize(normal, 0) - 1);
    return octahedral_decode(texelFetch(normal, pixel, 0).xy);
}

// Returns the mean over 4 × 4 texels, because the noise repeats every 4 texels. The loop reads 5 × 5 texels, and those
// at the edge count half.
Smooth smoothed(ivec2 texel, vec4 own) {
    const ivec2 last = textureSize(nearTraced, 0) - 1;
    const vec3 position = place_of(texel, own.w), n = normal_of(texel);
    const float tolerance = kPlaneShare * own.w;
    Smooth sum = Smooth(vec4(0.0), vec3(0.0));
    float weights = 0.0;
    for (int y = -2; y <= 2; ++y) {
        for (int x = -2; x <= 2; ++x) {
            const ivec2 at = texel + ivec2(x, y);
            if (any(lessThan(at, ivec2(0))) || any(greaterThan(at, last))) continue;
            const vec4 bent = texelFetch(nearBent, at, 0);
            if (bent.w <= 0.0) continue;
            const float off = abs(dot(place_of(at, bent.w) - position, n)) / tolerance;
            const float alike = smoothstep(kLeastCosine, 1.0, dot(n, normal_of(at)));
            const float weight = (abs(x) == 2 ? 0.5 : 1.0) * (abs(y) == 2 ? 0.5 : 1.0) * max(1.0 - off, 0.0) * alike;
            sum.light += weight * texelFetch(nearTraced, at, 0);
            sum.bent += weight * bent.xyz;
            weights += weight;
        }
    }
    if (weights < 1e-3) return Smooth(texelFetch(nearTraced, texel, 0), own.xyz);
    return Smooth(sum.light / weights, sum.bent / weights);
}

// Returns the place of the surface in the previous frame. xy: uv in the images of this module. z: distance to the eye
// in the previous frame, as if the surface had not moved.
vec3 place_before(ivec2 texel, vec4 own) {
    const vec2 size = vec2(textureSize(depth, 0));
    const ivec2 pixel = min(texel * int(params.nearScale), ivec2(size) - 1);
    const vec2 moved = texelFetch(velocity, pixel, 0).xy;
    const vec2 covered = vec2(textureSize(nearTraced, 0)) * float(params.nearScale);
    const vec4 now = view.steady_view_projection * vec4(place_of(texel, own.w), 1.0);
    const vec4 before = view.prev_view_projection * vec4(place_of(texel, own.w), 1.0);
    // A texel has the value of its first pixel. `first` is the offset from the centre of this pixel to the centre of
    // the texel.
    const vec2 first = (0.5 * float(params.nearScale) - 0.5) / covered;
    return vec3(((vec2(pixel) + 0.5) / size - moved) * size / covered + first, own.w * before.w / now.w);
}

void store(ivec2 texel, vec4 light, vec4 shape) {
    imageStore(nearField, ivec3(texel, 0), light);
    imageStore(nearField, ivec3(texel, 1), shape);
}

void main() {
    const ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(texel, imageSize(nearField).xy))) return;
    const vec4 own = texelFetch(nearBent, texel, 0);
    if (own.w <= 0.0) {
        store(texel, vec4(0.0, 0.0, 0.0, 1.0), vec4(0.0));
        return;
    }
    Smooth now = Smooth(texelFetch(nearTraced, texel, 0), own.xyz);
    float count = 0.0;
    if (params.nearSmooth != 0u) {
        now = smoothed(texel, own);
        const vec3 place = place_before(texel, own);
        const vec4 shape = textureLod(before, vec3(place.xy, 1.0), 0.0);
        const bool inside = all(greaterThanEqual(place.xy, vec2(0.0))) && all(lessThan(place.xy, vec2(1.0)));
        if (params.beforeValid > 0.0 && inside && abs(shape.z - place.z) < kSameDistance * place.z) {
            count = shape.w;
            const float weight = max(1.0 / (count + 1.0), params.nearNewest);
            vec4 light = textureLod(before, vec3(place.xy, 0.0), 0.0);
            light.rgb *= frame.pre_exposure / frame.prev_pre_exposure;
            now.light = mix(light, now.light, weight);
            now.bent = mix(octahedral_decode(shape.xy), normalize(now.bent), weight);
        }
        // In the first frame, no previous picture exists, and the near field contains no light. With the count 0, the
        // next frame replaces this result.
        count = params.beforeValid > 0.0 ? min(count + 1.0, 256.0) : 0.0;
    }
    store(texel, vec4(nearest_half(now.light.rgb), now.light.a), vec4(octahedral_encode(now.bent), own.w, count));
}
