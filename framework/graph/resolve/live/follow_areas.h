// Purpose: the stage of resolve() that finds the numbers that change with live scales: the areas of images,
// the numbers of workgroups, viewports, scissors and values in `Params` of passes. All other stages use the
// sizes at scale 1. Also checks that the areas of the images in each pass fit each other. Errors: W236.
#pragma once

#include "graph/resolve/version.h"

namespace weft {

// Adds the numbers that change with live scales to `graph`, the result of assemble(). Returns `graph`
// unchanged if no size has a scale.
[[nodiscard]] ResolvedGraph follow_areas(const Declared& declared, const VersionedGraph& versioned,
                                         Suspects suspects, ResolvedGraph graph, Reporter& reporter);

}  // namespace weft
