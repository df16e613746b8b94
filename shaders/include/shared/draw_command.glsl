// One draw of a list, as indirect draws read it: the list's import "opaqueCommands" holds one for each draw, and
// a pass that draws by a buffer of its own leaves out those whose instance_count is 0. 20 bytes, as the device
// wants it: for std430 only.
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
