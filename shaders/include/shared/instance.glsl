// One drawn object in set 3; gl_InstanceIndex selects it.
#ifndef WEFT_SHARED_INSTANCE
#define WEFT_SHARED_INSTANCE
#include "begin.glsl"

const int kNoStream = 0x7fffffff;

struct Instance {
    mat4 object_to_world;
    mat4 prev_object_to_world;
    mat4 normal_to_world;    // cofactor matrix of the upper 3×3, with the determinant's sign
    int color_offset;        // added to gl_VertexIndex to find the vertex's colour; kNoStream if the mesh has no colours
    int second_uv_offset;    // the same for second uvs
    int reserved0;
    int reserved1;
};

#include "end.glsl"
#endif
