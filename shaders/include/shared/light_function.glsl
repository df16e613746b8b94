// A light function shapes a light: barn doors, a picture (gobo), a falloff curve. Lights refer to it by
// index. Barzel 1997, "Lighting Controls for Computer Cinematography". Lengths are tangents of angles from
// the light's direction; for directional lights, which have no such angles, they are metres.
#ifndef WEFT_SHARED_LIGHT_FUNCTION
#define WEFT_SHARED_LIGHT_FUNCTION
#include "begin.glsl"

struct LightFunction {
    vec4 curve;             // Bézier ordinates of a factor over the distance from 0 to the range; constant beyond it
    vec4 doors;             // limits of the light towards −width, +width, −up and +up; kNoDoor: no limit
    vec2 picture_scale;     // 1 / half the size of the picture
    float reach_m;
    float softness;         // width of the transition at the edge of a door; pictures are blurred by the same width
    uint picture;           // 0: none; else 1 + the index of its layer
    uint reserved0;
    uint reserved1;
    uint reserved2;
};

const float kNoDoor = 1e6f;

#include "end.glsl"
#endif
