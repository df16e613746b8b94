// One light of the list that light_upload writes. Units: metres, candela (point, spot), lux (directional).
#ifndef WEFT_SHARED_LIGHT
#define WEFT_SHARED_LIGHT
#include "begin.glsl"

const uint kLightDirectional = 0u;
const uint kLightPoint = 1u;
const uint kLightSpot = 2u;

struct Light {
    vec3 position;
    float range_m;       // 0: unlimited
    vec3 intensity;      // colour × cd or lx, Rec.709
    uint type;
    vec3 direction;      // in which the light travels
    float cone_scale;    // spot: saturate(cos(angle) · scale + offset)², as KHR_lights_punctual recommends
    float cone_offset;
    uint reserved0;      // shadow and light-function indices will live here
    uint reserved1;
    uint reserved2;
};

#include "end.glsl"
#endif
