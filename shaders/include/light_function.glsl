// Computes the light function of a light: one factor per colour channel for the light towards a point. Barn doors, a
// picture or a falloff curve determine the factors. For lights without a light function, all factors are 1.
#ifndef WEFT_LIGHT_FUNCTION
#define WEFT_LIGHT_FUNCTION
#include "frame_set.glsl"
#include "shared/light.glsl"

// The axes of a light: its direction (`forward`), and the axes of width and height for its doors and pictures. A
// capsule faces in the direction `side`, perpendicular to its axis.
struct LightFrame {
    vec3 width;
    vec3 up;
    vec3 forward;
};

LightFrame light_frame(Light light) {
    if (light.type == kLightCapsule)
        return LightFrame(light.direction, cross(light.direction, light.side), light.side);
    return LightFrame(light.side, cross(light.side, light.direction), light.direction);
}

float falloff_curve(LightFunction f, float distance_m) {
    const float t = clamp(distance_m / f.reach_m, 0.0, 1.0), s = 1.0 - t;
    return dot(f.curve, vec4(s * s * s, 3.0 * s * s * t, 3.0 * s * t * t, t * t * t));
}

// Returns 1 between the barn doors (the four flaps) of a lamp and 0 behind a flap. `at` is a position on the
// plane at distance 1 in front of the light.
float between_doors(LightFunction f, vec2 at) {
    const vec4 within = f.doors + vec4(at.x, -at.x, at.y, -at.y);
    const vec4 open = smoothstep(vec4(-0.5 * f.softness), vec4(0.5 * f.softness), within);
    return open.x * open.y * open.z * open.w;
}

// Returns the colour of the light's picture at `uv`. `footprint`: width of the area to average, as a share of the side
// of the picture. The area is a screen pixel, enlarged by the softness.
vec3 light_picture(LightFunction f, vec2 uv, float footprint) {
    const float size_px = float(textureSize(light_pictures, 0).x);
    const float lod = log2(max(footprint * size_px, 1.0));
    return textureLod(light_pictures, vec3(uv, float(f.picture - 1u)), lod).rgb;
}

// A position in the picture of a light, and the share of the light that passes through the picture. The share is 0
// outside the picture of a projector.
struct PictureSpot {
    vec2 uv;
    float footprint;
    float weight;
};

// Finds the position in a picture that surrounds a point light. The middle of the picture is in the direction
// `forward` of the light, its top edge in the direction `up`.
PictureSpot picture_around(LightFunction f, vec3 local, float distance_m, float pixel_m) {
    const vec2 uv = vec2(0.5 + atan(local.x, local.z) / 6.28318530718, acos(clamp(local.y, -1.0, 1.0)) / 3.14159265359);
    return PictureSpot(uv, (pixel_m / distance_m + f.softness) / 3.14159265359, 1.0);
}

// Finds the position in a projected picture. The picture is on the plane at distance 1 in front of the light,
// and its edges are soft. For directional lights (`endless`), the size of the picture is in metres, and the
// picture repeats. `at`: position on this plane. `pixel`: width of a screen pixel on this plane.
PictureSpot picture_ahead(LightFunction f, vec2 at, float pixel, bool endless) {
    const vec2 place = at * f.picture_scale;
    const vec2 inside = (1.0 - abs(place)) / (f.picture_scale * f.softness);
    const float weight = endless ? 1.0 : clamp(inside.x, 0.0, 1.0) * clamp(inside.y, 0.0, 1.0);
    const float footprint = 0.5 * max(f.picture_scale.x, f.picture_scale.y) * (pixel + f.softness);
    return PictureSpot(0.5 + 0.5 * vec2(place.x, -place.y), footprint, weight);
}

// `pixel_m`: the picture of the light is averaged over an area with this width at `position`, in metres.
vec3 light_function(Light light, vec3 position, float pixel_m) {
    if (light.function == 0u) return vec3(1.0);
    const LightFunction f = light_functions.items[light.function - 1u];
    const LightFrame frame_of_light = light_frame(light);
    const vec3 way = position - light.position;
    const vec3 at = vec3(dot(way, frame_of_light.width), dot(way, frame_of_light.up), dot(way, frame_of_light.forward));
    const float distance_m = max(length(way), 1e-4);
    const bool parallel = light.type == kLightDirectional, around = light.type == kLightPoint && f.picture != 0u;
    float open = parallel ? 1.0 : falloff_curve(f, distance_m);
    PictureSpot spot;
    if (around) {
        spot = picture_around(f, at / distance_m, distance_m, pixel_m);
    } else if (!parallel && at.z <= 1e-4 * distance_m) {
        return any(lessThan(f.doors, vec4(kNoDoor))) ? vec3(0.0) : vec3(open);
    } else {
        const float depth_m = parallel ? 1.0 : at.z;
        open *= between_doors(f, at.xy / depth_m);
        spot = picture_ahead(f, at.xy / depth_m, pixel_m / depth_m, parallel);
    }
    if (f.picture == 0u) return vec3(open);
    return open * spot.weight == 0.0 ? vec3(0.0) : open * spot.weight * light_picture(f, spot.uv, spot.footprint);
}

// Averages the picture of the light over a pixel of the screen.
vec3 light_function(Light light, vec3 position) {
    const float pixel_m = distance(position, view.eye) * 2.0 * view.inverse_viewport.y / abs(view.projection[1][1]);
    return light_function(light, position, pixel_m);
}
#endif
