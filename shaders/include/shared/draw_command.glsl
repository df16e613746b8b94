// One draw of a draw list, in the layout of VkDrawIndexedIndirectCommand. The import "opaqueCommands" has one such
// command per draw of the list "opaque". A pass can write its own commands; instance_count = 0 skips a draw. The size
// is 20 bytes, as Vulkan requires, so the struct works only with std430.
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
