// Finds the lamps that a light probe sees. A lamp that is hidden from the probe gives no light to the surfaces that the
// probe sees; otherwise lamps would shine through walls, because most of them have no shadow maps.
#ifndef WEFT_LAMP_SHARE
#define WEFT_LAMP_SHARE
#include "cube_texels.glsl"
#include "shared/light.glsl"

uniform sampler2DArray probeDistance;  // Six faces: distance in m, 0: nothing there, negative: back of a surface.

// The glass or the shade of a lamp may surround the position of its light. A surface that is at most this much nearer
// to the probe than the light does not hide the light.
const float kLampHousing_m = 0.2;

// Returns how much of a point the probe sees, from 0 to 1. Each of the 2 × 2 texels around the direction of the point
// counts if the probe sees there at least as far as the point, minus `housing_m`. The weights are those of a linear
// filter.
float seen_share(vec3 to_point, float housing_m) {
    const float away_m = length(to_point) - housing_m;
    if (away_m <= 0.0) return 1.0;
    vec2 place;
    const uint face = face_of_direction(to_point, place);
    const int size = textureSize(probeDistance, 0).x;
    const vec2 at = (place * 0.5 + 0.5) * float(size) - 0.5;
    const vec2 f = at - floor(at);
    float share = 0.0;
    for (int i = 0; i < 4; ++i) {
        const ivec2 offset = ivec2(i & 1, i >> 1);
        const ivec2 texel = clamp(ivec2(floor(at)) + offset, ivec2(0), ivec2(size - 1));
        const float distance_m = abs(texelFetch(probeDistance, ivec3(texel, int(face)), 0).r);
        const vec2 weight = mix(1.0 - f, f, vec2(offset));
        share += distance_m == 0.0 || distance_m >= away_m ? weight.x * weight.y : 0.0;
    }
    return share;
}

// Returns the share of a lamp that a probe at the place `probe` sees. For a capsule or a rectangle, this is the mean
// over five points of its shape.
float lamp_share(Light light, vec3 probe) {
    const vec3 to_light = light.position - probe;
    if (light.type < kLightCapsule) return seen_share(to_light, kLampHousing_m);
    const bool is_capsule = light.type == kLightCapsule;
    const float housing_m = kLampHousing_m + (is_capsule ? light.half_size_m.y : 0.0);
    const vec3 x = (is_capsule ? light.direction : light.side) * light.half_size_m.x;
    const vec3 y = is_capsule ? 0.5 * x : cross(light.side, light.direction) * light.half_size_m.y;
    float share = 0.0;
    for (int i = 0; i < 5; ++i) {
        const vec3 point = i == 0 ? vec3(0.0) : (i < 3 ? x : y) * ((i & 1) == 0 ? -1.0 : 1.0);
        share += 0.2 * seen_share(to_light + point, housing_m);
    }
    return share;
}

// Returns true if the point is on the shape of a lamp or on its housing. The emission of such a surface is the light of
// the lamp. The scene already gets this light from the lamp.
bool is_on_lamp(Light light, vec3 position) {
    vec3 way = position - light.position;
    float reach_m = kLampHousing_m;
    if (light.type == kLightCapsule) {
        const float along = dot(way, light.direction);
        way -= light.direction * clamp(along, -light.half_size_m.x, light.half_size_m.x);
        reach_m += light.half_size_m.y;
    } else if (light.type == kLightRectangle) {
        const vec3 up = cross(light.side, light.direction);
        way -= light.side * clamp(dot(way, light.side), -light.half_size_m.x, light.half_size_m.x);
        way -= up * clamp(dot(way, up), -light.half_size_m.y, light.half_size_m.y);
    }
    return dot(way, way) < reach_m * reach_m;
}
#endif
