// Cascades of the sun's shadow maps, in descriptor set 0. Each cascade has its own shadow map. A point uses the first
// map that contains it; the last map contains all points that have shadows. Units: metres.
#ifndef WEFT_SHARED_SUN
#define WEFT_SHARED_SUN
#include "begin.glsl"

const int kMostSunCascades = 4;
// Near its edge, a map is blended with the next map that contains the point. This is the width of the band in which
// maps are blended, in texels.
const float kSunBlendTexels = 8.0f;
// Shadows fade out over the last part of the distance end_m. This part has the length kSunFade × end_m.
const float kSunFade = 0.1f;

struct SunCascade {
    mat4 world_to_map;   // World to (u, v, depth). Depth is linear: 1 nearest to the sun, 0 farthest from it.
    vec2 texel_m;        // Width and height of a texel, in metres.
    float depth_m;       // Distance from depth 1 to depth 0, in metres.
    float end_m;         // Shadows end at this distance from the eye, in metres. The same for all cascades.
};

struct SunConstants {
    SunCascade cascades[kMostSunCascades];
    vec3 to_sun;
    uint count;          // Number of cascades; 0 if the graph draws no shadow maps of the sun.
};

#include "end.glsl"
#endif
