// One drawn object, as set 3 holds it; gl_InstanceIndex selects it.
#ifndef WEFT_SHARED_INSTANCE
#define WEFT_SHARED_INSTANCE
#include "begin.glsl"

struct Instance {
    mat4 object_to_world;
    mat4 prev_object_to_world;
    mat4 normal_to_world;    // cofactor matrix of the upper 3×3, with the determinant's sign
};

#include "end.glsl"
#endif
