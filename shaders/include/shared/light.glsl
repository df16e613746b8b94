// One light of the list that light_upload writes. Units: metres, candela (point, spot), lux (directional), cd/m²
// (capsule, rectangle).
#ifndef WEFT_SHARED_LIGHT
#define WEFT_SHARED_LIGHT
#include "begin.glsl"

const uint kLightDirectional = 0u;
const uint kLightPoint = 1u;
const uint kLightSpot = 2u;
const uint kLightCapsule = 3u;
const uint kLightRectangle = 4u;

struct Light {
    vec3 position;       // centre of the light
    float range_m;       // from the nearest point of the shape; 0: unlimited
    vec3 intensity;      // colour × the unit above, Rec.709
    uint type;
    vec3 direction;      // direction in which the light travels; for a capsule its axis. Unit length
    float cone_scale;    // spot: saturate(cos(angle) · scale + offset)², as KHR_lights_punctual recommends
    vec3 side;           // unit length, perpendicular to the direction: the width axis of a rectangle, of
                         // doors and pictures
    float cone_offset;
    vec2 half_size_m;    // rectangle: half width, half height; capsule: half length without the caps, radius
    uint function;       // 0: none; else 1 + the index of its light function
    uint shadow;         // 0: no shadow; else 1 + the index of its shadow
};

#include "end.glsl"
#endif
