// Two sets of shadow maps, in descriptor set 0. The first set has one map for each of the directional lights 2 to 4, for
// the main camera. The second set has one map for each of the directional lights 1 to 4; these maps cover the whole
// scene, and the light probes use them. Units: metres.
#ifndef WEFT_SHARED_FURTHER_SUNS
#define WEFT_SHARED_FURTHER_SUNS
#include "begin.glsl"

const int kMostFurtherSuns = 3;
const int kMostSceneSuns = 4;

struct FurtherSun {
    mat4 world_to_map;   // World to (u, v, depth). Depth is linear: 1 nearest to the light, 0 farthest from it.
    vec3 to_sun;         // Unit vector towards the light.
    float texel_m;       // Length of the side of a texel; 0: the light has no map.
    vec3 reserved;
    float depth_m;       // Distance from depth 1 to depth 0.
};

struct FurtherSuns {
    FurtherSun items[kMostFurtherSuns];
    FurtherSun scene[kMostSceneSuns];  // Directional lights 1 to 4: maps of the objects that do not move.
};

#include "end.glsl"
#endif
