// Purpose: chooses among the alternative formats of an image. All tiers share the first format that the
// device supports for each tier's use of the image, so that images keep their content when the tier changes.
// common_formats() in load_graph.h finds the formats once for all tiers.
#pragma once

#include "weft/load/load_graph.h"

namespace weft {

// One tier of a graph, and how it uses its images.
struct TierVariant {
    GraphDesc desc;
    ShaderCatalog shaders;
};

// The formats for the tier of `input`, with its parameters and observers; the other tiers are loaded without.
[[nodiscard]] SkippedFormats formats_with_others(const JsonDoc& document, const TierVariant& own,
                                                 const LoadInput& input);

}  // namespace weft
