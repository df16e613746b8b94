// The cascades of the sun's shadow maps in set 0: nested parts of the view, each with its own map. Units:
// metres.
#ifndef WEFT_SHARED_SUN
#define WEFT_SHARED_SUN
#include "begin.glsl"

const int kMostSunCascades = 4;
// The last part of a cascade, in which it is blended with the next one.
const float kSunBlend = 0.1f;

struct SunCascade {
    mat4 world_to_map;   // world to (u, v, depth): depth is linear, 1 nearest to the sun, 0 farthest from it
    float end_m;         // the cascade is used up to this distance from the eye
    float texel_m;       // side of a texel
    float depth_m;       // distance between depth 1 and depth 0
    float reserved;
};

struct SunConstants {
    SunCascade cascades[kMostSunCascades];
    vec3 to_sun;
    uint count;          // number of cascades; 0: no pass of the graph draws the sun's view
};

#include "end.glsl"
#endif
