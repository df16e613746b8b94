// One drawn object, as set 3 holds it; gl_InstanceIndex selects it.
#ifndef WEFT_SHARED_INSTANCE
#define WEFT_SHARED_INSTANCE
#include "begin.glsl"

const int kNoStream = 0x7fffffff;

struct Instance {
    mat4 object_to_world;
    mat4 prev_object_to_world;
    mat4 normal_to_world;    // cofactor matrix of the upper 3×3, with the determinant's sign
    int color_offset;        // added to gl_VertexIndex: where the vertex's colour is; kNoStream where the mesh has none
    int second_uv_offset;    // likewise
    int reserved0;
    int reserved1;
};

#include "end.glsl"
#endif
