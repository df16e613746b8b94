// Purpose: finds the extent, mips, layers and size in bytes of one image or buffer that the graph describes.
// Private to shape_resources().
#pragma once

#include "graph/resolve/shape_resources.h"

namespace weft {

// Fills in the resource and its mip count. After reporting an error, marks the shape as suspect, so that
// later stages report no consequences.
void shape_resource(const ResolveInput& input, const Values& values, ResourceId id, Shapes& shapes,
                    Reporter& reporter);

}  // namespace weft
