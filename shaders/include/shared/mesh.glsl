// One mesh of the scene, an element of the imported buffer `meshes`. Instance::mesh is the index of an object's mesh.
#ifndef WEFT_SHARED_MESH
#define WEFT_SHARED_MESH
#include "begin.glsl"

struct Mesh {
    vec3 least;           // Bounding box in the space of the mesh: the smallest and the greatest coordinates.
    uint first_index;     // See DrawCommand::first_index.
    vec3 most;
    uint index_count;     // See DrawCommand::index_count.
    int vertex_offset;    // See DrawCommand::vertex_offset.
    uint vertex_count;
    uint reserved0;
    uint reserved1;
};

#include "end.glsl"
#endif
