// Purpose: extent, mips, layers and bytes of one described image or buffer. Private to shape_resources().
#pragma once

#include "graph/resolve/shape_resources.h"

namespace weft {

// Fills in the resource and its mip count, and marks its shape as suspect where a fault is reported.
void shape_resource(const ResolveInput& input, const Values& values, ResourceId id, Shapes& shapes,
                    Reporter& reporter);

}  // namespace weft
