// The box of a reflection probe, an element of the import `reflectionBoxes`. The probe counts only in its box.
#ifndef WEFT_SHARED_REFLECTION_BOX
#define WEFT_SHARED_REFLECTION_BOX
#include "begin.glsl"

struct ReflectionBox {
    // Rows of the matrix from world space to the box, which reaches from −1 to 1. All 0: the probe has no box.
    vec4 to_box[3];
    vec4 reserved;
};

// Items of the buffer `reflectionMap` for each probe.
const uint kReflectionItems = 4u;

#include "end.glsl"
#endif
