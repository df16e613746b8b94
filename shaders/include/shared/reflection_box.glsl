// The box of a reflection probe, an element of the imported buffer `reflectionBoxes`. The probe gives light to points
// in its box. Outside the box, the weight of the probe soon falls to 0.
#ifndef WEFT_SHARED_REFLECTION_BOX
#define WEFT_SHARED_REFLECTION_BOX
#include "begin.glsl"

struct ReflectionBox {
    // Rows of the matrix from world space to the space of the box, in which the box reaches from −1 to 1. All 0: the
    // probe has no box.
    vec4 to_box[3];
    vec4 reserved;
};

// Number of items that each probe has in the buffer `reflectionMap`.
const uint kReflectionItems = 4u;

#include "end.glsl"
#endif
