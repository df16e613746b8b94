// One draw without a draw list, in the layout of VkDrawIndirectCommand. A pass writes such commands for "draws":
// { "indirect": buffer }; instance_count = 0 skips a draw. The shader gets first_vertex as the first gl_VertexIndex and
// first_instance as the first gl_InstanceIndex. first_instance must be 0 if the device lacks drawIndirectFirstInstance.
#ifndef WEFT_SHARED_DRAW_VERTICES_COMMAND
#define WEFT_SHARED_DRAW_VERTICES_COMMAND
#include "begin.glsl"

struct DrawVerticesCommand {
    uint vertex_count;
    uint instance_count;
    uint first_vertex;
    uint first_instance;
};

#include "end.glsl"
#endif
