// What stands before a light and shapes it: barn doors, a picture (gobo), a falloff curve. A light names one by its index.
// Barzel 1997, "Lighting Controls for Computer Cinematography". Lengths are tangents of angles from the way the light
// faces; for directional lights, which have no angles, metres.
#ifndef WEFT_SHARED_LIGHT_FUNCTION
#define WEFT_SHARED_LIGHT_FUNCTION
#include "begin.glsl"

struct LightFunction {
    vec4 curve;             // Bézier ordinates of a factor, over the distance from 0 to the reach; constant beyond it
    vec4 doors;             // where the light ends towards −width, +width, −up and +up; kNoDoor: nowhere
    vec2 picture_scale;     // 1 / half of what the picture spans
    float reach_m;
    float softness;         // over which the edge of a door fades; pictures are blurred by as much
    uint picture;           // 0: none; else 1 + its layer
    uint reserved0;
    uint reserved1;
    uint reserved2;
};

const float kNoDoor = 1e6f;

#include "end.glsl"
#endif
