// Bounding box of one drawn object in world space, an element of the import `bounds`. The index is that of the object
// in the import `instances`. Units: metres.
#ifndef WEFT_SHARED_BOUNDS
#define WEFT_SHARED_BOUNDS
#include "begin.glsl"

struct Bounds {
    vec3 least;      // Corner with the smallest coordinates.
    uint reserved0;
    vec3 most;       // Corner with the greatest coordinates.
    uint reserved1;
};

#include "end.glsl"
#endif
