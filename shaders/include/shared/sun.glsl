// Cascades of the sun's shadow maps, in descriptor set 0. A cascade is used for points between two distances from
// the eye, and has its own shadow map. Cascade 0 is the nearest. Units: metres.
#ifndef WEFT_SHARED_SUN
#define WEFT_SHARED_SUN
#include "begin.glsl"

const int kMostSunCascades = 4;
// A cascade is blended with the next one over the last part of its range. This part has the length kSunBlend × end_m.
const float kSunBlend = 0.1f;

struct SunCascade {
    mat4 world_to_map;   // World to (u, v, depth). Depth is linear: 1 nearest to the sun, 0 farthest from it.
    float end_m;         // The cascade is used up to this distance from the eye, in metres.
    float texel_m;       // Length of the side of a texel, in metres.
    float depth_m;       // Distance from depth 1 to depth 0, in metres.
    float reserved;
};

struct SunConstants {
    SunCascade cascades[kMostSunCascades];
    vec3 to_sun;
    uint count;          // Number of cascades; 0 if the graph draws no shadow maps of the sun.
};

#include "end.glsl"
#endif
