// Purpose: finds the buffers of indirect draws, and checks their sizes. Private to size_dispatches().
#pragma once

#include "graph/resolve/size_dispatches.h"

namespace weft {

// Returns true if the elements of a buffer are floats. Such a buffer cannot contain numbers of workgroups,
// numbers of draws or draw commands.
[[nodiscard]] bool holds_floats(const Shapes& shapes, ResourceId resource);

// Finds the buffers with the draw commands and with the number of draws of a raster pass. Checks that the
// buffers are large enough, and that the device can execute such draws. Errors: W114, W187, W195.
void find_draw_commands(const Declared& declared, const VersionedGraph& graph, PassId pass,
                        Dispatches& dispatches, PassReporter& report);

}  // namespace weft
