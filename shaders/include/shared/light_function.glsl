// A light function shapes a light with barn doors, a picture (gobo) and a falloff curve. Lights refer to it by index.
// Source: Barzel 1997, "Lighting Controls for Computer Cinematography". Doors, pictures and soft edges are
// measured on the plane at distance 1 in front of the light, so their lengths are tangents of angles. For directional
// lights, these lengths are in metres.
#ifndef WEFT_SHARED_LIGHT_FUNCTION
#define WEFT_SHARED_LIGHT_FUNCTION
#include "begin.glsl"

struct LightFunction {
    // Factor of the light over the distance: a cubic Bézier curve with 4 ordinates, from distance 0 to reach_m.
    vec4 curve;
    // Positions of the four barn doors: left, right, bottom, top. Each is the distance from the light's direction to
    // the edge of the door, along the axis `width` or `up` (LightFrame), on the plane at distance 1 in front of the
    // light (for directional lights: in metres). Light beyond the edge is blocked. kNoDoor: no door.
    vec4 doors;
    vec2 picture_scale;     // 1 / (half the size of the picture). The size has the unit of `doors`.
    float reach_m;
    // Width of the soft edge of a door, in the unit of `doors`. Pictures are blurred by this width, too.
    float softness;
    uint picture;           // 0: no picture; otherwise 1 + the layer of the picture.
    uint reserved0;
    uint reserved1;
    uint reserved2;
};

const float kNoDoor = 1e6f;

#include "end.glsl"
#endif
