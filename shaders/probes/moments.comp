// Makes the octahedral map of the surfaces that a probe sees. Lookups use the map to find out whether the probe sees a
// point. The inverse distance is 0 where there is no surface. On a plane, the inverse distance is the dot product of
// the direction and a vector: the normal divided by the distance of the plane from the probe. Each texel gets the plane
// of one surface that is seen within the texel. rgb: the vector, in 1/m; a: standard deviation of the inverse distance
// of this surface from the plane. A wall has nearly no deviation and the same vector everywhere, even where the probe
// sees it at a grazing angle. The map has 32 × 32 texels and a border of one texel, which continues the map beyond its
// edges.
//
// A plane fitted to all surfaces within a texel would be wrong where the texel covers the edge of a surface. The plane
// would lie behind the near surface and in front of the far one, so light would leak through walls near their edges.
#version 460
#include "cube_texels.glsl"
#include "octahedral.glsl"
#include "probe_map.glsl"

layout(local_size_x = 9, local_size_y = 9) in;

uniform sampler2DArray faces;
layout(rgba16f) writeonly uniform image2D moments;

const int kSide = int(kProbeMomentSide);
// Samples per side of a texel. A texel is about as large as 2.4 × 2.4 texels of a face with 32 × 32 texels.
const int kSamples = 5;
const int kAll = kSamples * kSamples;
// A plane behind a surface lets light through the surface. A plane in front of a surface hides places that the probe
// sees. The first error counts this many times as much as the second.
const float kOpenCost = 2.0;
// The surface of a sample belongs to a plane if their inverse distances differ by at most this share of the inverse
// distance of the surface.
const float kSameSurface = 0.05;
// At the border of a face, there is no third texel, so it is unknown whether the change from texel to texel is steady.
// The unsteadiness of this change is then assumed to be this share of slope_at().
const float kNoThird = 1e-3;

// Returns the texel of the map that has the content of the texel `at`. Texels of the border are copies of other texels.
ivec2 wrapped(ivec2 at) {
    if (at.x < 0 || at.x >= kSide) at = ivec2(clamp(at.x, 0, kSide - 1), kSide - 1 - at.y);
    if (at.y < 0 || at.y >= kSide) at = ivec2(kSide - 1 - at.x, clamp(at.y, 0, kSide - 1));
    return at;
}

// The surface that the probe sees in one texel of its six faces: the plane of the surface, and its inverse distance from
// the probe, in the direction of the middle of the texel.
struct Sight {
    vec3 direction, plane;
    float near;
    float unsteady;  // How unevenly the inverse distance changes around the texel, from 0 (evenly) to 1.
};

// Returns the dot product of the plane's vector and the unnormalised direction of a texel. Where the surface is flat,
// the product is a linear function of the place on the face. Returns 0 if there is no surface.
float slope_at(ivec2 texel, uint face) {
    const int size = textureSize(faces, 0).x;
    const float distance = abs(texelFetch(faces, ivec3(texel, face), 0).r);
    const vec2 place = face_position(uvec2(texel), float(size));
    return distance > 0.0 ? sqrt(1.0 + dot(place, place)) / distance : 0.0;
}

// Returns the change of slope_at() from texel to texel. Uses the texels of the side on which the change is steadiest,
// so that the edge of a surface does not count. Adds to `unsteady` the difference between this change and the next one.
float gradient(ivec2 texel, uint face, ivec2 axis, inout float unsteady) {
    const int size = textureSize(faces, 0).x, at = axis.x * texel.x + axis.y * texel.y;
    float w[5];
    for (int i = 0; i < 5; ++i) w[i] = slope_at(texel + axis * clamp(i - 2, -at, size - 1 - at), face);
    const float doubt = kNoThird * w[2];
    const float low = at >= 2 ? abs(w[0] - 2.0 * w[1] + w[2]) : at == 1 ? doubt : 1e30;
    const float middle = at >= 1 && at + 1 < size ? abs(w[1] - 2.0 * w[2] + w[3]) : 1e30;
    const float high = at + 2 < size ? abs(w[2] - 2.0 * w[3] + w[4]) : at + 2 == size ? doubt : 1e30;
    unsteady += min(middle, min(low, high));
    if (middle <= min(low, high)) return (w[3] - w[1]) * 0.5;
    return low <= high ? w[2] - w[1] : w[3] - w[2];
}

Sight sight_along(vec3 direction) {
    const int size = textureSize(faces, 0).x;
    vec2 at;
    const uint face = face_of_direction(direction, at);
    const ivec2 texel = min(ivec2((at * 0.5 + 0.5) * float(size)), size - 1);
    const vec2 place = face_position(uvec2(texel), float(size));
    const vec3 ahead = face_direction(face, vec2(0.0));
    const vec3 u = face_direction(face, vec2(1.0, 0.0)) - ahead, v = face_direction(face, vec2(0.0, 1.0)) - ahead;
    const float w = slope_at(texel, face);
    Sight sight;
    sight.direction = normalize(face_direction(face, place));
    sight.near = w * inversesqrt(1.0 + dot(place, place));
    sight.plane = vec3(0.0);
    sight.unsteady = 0.0;
    if (w == 0.0) return sight;
    const vec2 steps = vec2(gradient(texel, face, ivec2(1, 0), sight.unsteady),
                            gradient(texel, face, ivec2(0, 1), sight.unsteady));
    sight.unsteady = min(sight.unsteady / (kSameSurface * w), 1.0);
    const vec2 g = steps * (0.5 * float(size));
    sight.plane = ahead * (w - dot(place, g)) + u * g.x + v * g.y;
    return sight;
}

// Returns the point of the octahedron for a position in the map, in texels. The map is an octahedron laid flat.
vec3 octahedron_point(vec2 position) {
    const vec2 e = position / float(kSide) * 2.0 - 1.0;
    vec3 point = vec3(e, 1.0 - abs(e.x) - abs(e.y));
    if (point.z < 0.0) point.xy = (1.0 - abs(point.yx)) * sign_not_zero(point.xy);
    return point;
}

// The surfaces that the probe sees within a texel of the map, at kAll places.
Sight sights[kAll];
float weights[kAll];

void look_around(vec2 texel) {
    for (int i = 0; i < kAll; ++i) {
        const vec3 point = octahedron_point(texel + (vec2(i % kSamples, i / kSamples) + 0.5) / float(kSamples));
        // The weight is the solid angle of a piece of the octahedron, as seen from its middle: pieces that are farther
        // away look smaller.
        const float inverse_length = inversesqrt(dot(point, point));
        weights[i] = inverse_length * inverse_length * inverse_length;
        sights[i] = sight_along(point * inverse_length);
    }
}

// Returns the inverse distance of the plane, minus that of the surface that sample i sees, in the direction of the
// sample.
float error_of(vec3 plane, int i) { return dot(plane, sights[i].direction) - sights[i].near; }

// Returns the plane that describes the surfaces of all samples best. Each sample gives one plane to choose from.
vec3 best_plane() {
    int best = 0;
    float least = 1e30;
    for (int k = 0; k < kAll; ++k) {
        float cost = 0.0;
        for (int i = 0; i < kAll; ++i) {
            cost += weights[i] * sights[k].unsteady;
            const float error = error_of(sights[k].plane, i);
            const float share = min(abs(error) / max(kSameSurface * sights[i].near, 1e-6), 1.0);
            cost += weights[i] * share * (error < 0.0 ? kOpenCost : 1.0);
        }
        if (cost < least) best = k;
        least = min(least, cost);
    }
    return sights[best].plane;
}

// Returns the standard deviation from the plane of the samples that belong to the plane.
float deviation_from(vec3 plane) {
    float sum = 0.0, count = 0.0;
    for (int i = 0; i < kAll; ++i) {
        const float error = error_of(plane, i);
        if (abs(error) > kSameSurface * sights[i].near) continue;
        sum += weights[i] * error * error;
        count += weights[i];
    }
    return sqrt(sum / max(count, 1e-6));
}

void main() {
    const ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(at, imageSize(moments)))) return;
    look_around(vec2(wrapped(at - 1)));
    const vec3 plane = best_plane();
    imageStore(moments, at, vec4(plane, deviation_from(plane)));
}
