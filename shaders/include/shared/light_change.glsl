// A light that differs from that of the previous frame, an element of the import `lightChanges`. Units: metres, candela.
#ifndef WEFT_SHARED_LIGHT_CHANGE
#define WEFT_SHARED_LIGHT_CHANGE
#include "begin.glsl"

// Number of elements of the import. If more lights change in a frame, the weakest of them are left out.
const uint kMostLightChanges = 64u;
// A directional light has the distance kFarLight_m in the direction of its light, and an intensity in candela that gives
// its illuminance at this distance.
const float kFarLight_m = 1e6;

struct LightChange {
    vec3 position_before;
    float intensity_before;  // Luminous intensity in the direction in which the light is strongest; 0: it was off.
    vec3 position;
    float intensity;         // The same in this frame. An element with both intensities 0 ends the list.
};

#include "end.glsl"
#endif
