// Purpose: a format with alternatives is the first that the device supports for what any tier does with it:
// so images keep their contents from tier to tier. load_graph.h has the way to find them once for all tiers.
#pragma once

#include "weft/load/load_graph.h"

namespace weft {

// One tier of a graph, for what it does with its images.
struct TierVariant {
    GraphDesc desc;
    ShaderCatalog shaders;
};

// For the tier of `input`, with its parameters and observers; the other tiers have none.
[[nodiscard]] SkippedFormats formats_with_others(const JsonDoc& document, const TierVariant& own,
                                                 const LoadInput& input);

}  // namespace weft
