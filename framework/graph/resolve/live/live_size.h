// Purpose: finds out whether a live scale (a parameter that multiplies a size and may change in every frame)
// changes the size of an image, before passes are made.
#pragma once

#include "graph/resolve/evaluate.h"

namespace weft {

[[nodiscard]] bool has_live_size(const ResolveInput& input, const Values& values, const ResourceDesc& image);

}  // namespace weft
