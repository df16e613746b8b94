// Data of one drawn object, an element of the buffer in descriptor set 3. gl_InstanceIndex selects the element.
#ifndef WEFT_SHARED_INSTANCE
#define WEFT_SHARED_INSTANCE
#include "begin.glsl"

const int kNoStream = 0x7fffffff;

struct Instance {
    mat4 object_to_world;
    mat4 prev_object_to_world;
    mat4 normal_to_world;    // Matrix for normals: cofactors of the upper 3×3, with the sign of the determinant.
    int color_offset;        // gl_VertexIndex + this = index of the vertex colour; kNoStream: no vertex colours.
    int second_uv_offset;    // gl_VertexIndex + this = index of the second uv; kNoStream: no second uv.
    uint mesh;               // Index in the import `meshes`.
    uint material;           // Index in the import `materials`.
};

#include "end.glsl"
#endif
