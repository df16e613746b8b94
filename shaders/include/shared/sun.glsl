// The cascades of the sun's shadow maps, as set 0 holds them: nested parts of what the camera sees, each in a map of
// its own. Units: metres.
#ifndef WEFT_SHARED_SUN
#define WEFT_SHARED_SUN
#include "begin.glsl"

const int kMostSunCascades = 4;
// The last part of a cascade, in which it gives way to the next one.
const float kSunBlend = 0.1f;

struct SunCascade {
    mat4 world_to_map;   // to (u, v, depth): depth 1 nearest to the sun, 0 farthest from it, linear
    float end_m;         // distance from the eye up to which the cascade serves
    float texel_m;       // side of a texel
    float depth_m;       // from depth 1 to depth 0
    float reserved;
};

struct SunConstants {
    SunCascade cascades[kMostSunCascades];
    vec3 to_sun;
    uint count;          // of the cascades; 0: no pass of the graph looks through the sun's eyes
};

#include "end.glsl"
#endif
