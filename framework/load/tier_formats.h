// Purpose: chooses the format of images with alternatives: the first one that the device supports for the
// uses of all tiers together, so that images keep their contents when the tier changes. load_graph.h explains
// how to compute this once for all tiers.
#pragma once

#include "weft/load/load_graph.h"

namespace weft {

// One tier of a graph; its uses of images affect the choice.
struct TierVariant {
    GraphDesc desc;
    ShaderCatalog shaders;
};

// Includes the tier of `input` with its parameters and observers; the other tiers have none.
[[nodiscard]] SkippedFormats formats_with_others(const JsonDoc& document, const TierVariant& own,
                                                 const LoadInput& input);

}  // namespace weft
