// Purpose: the stage of resolve() that finds the numbers that follow live scales: the areas of images, and
// the workgroups, viewports, scissors and `Params` of passes. All other stages use the sizes at scale 1.
// Checks that passes agree about their areas. Errors: W236.
#pragma once

#include "graph/resolve/version.h"

namespace weft {

// Adds these numbers to `graph`, the result of assemble(). Returns it unchanged if no size has a scale.
[[nodiscard]] ResolvedGraph follow_areas(const Declared& declared, const VersionedGraph& versioned,
                                         Suspects suspects, ResolvedGraph graph, Reporter& reporter);

}  // namespace weft
