// One draw of a list in the form of an indirect draw. The list's import "opaqueCommands" has one for each
// draw; a pass with its own buffer of commands skips draws by setting instance_count to 0. 20 bytes, as
// Vulkan requires: for std430 only.
#ifndef WEFT_SHARED_DRAW_COMMAND
#define WEFT_SHARED_DRAW_COMMAND
#include "begin.glsl"

struct DrawCommand {
    uint index_count;
    uint instance_count;
    uint first_index;
    int vertex_offset;
    uint first_instance;
};

#include "end.glsl"
#endif
