// Purpose: chooses one of the alternative formats of an image ("rg16_snorm|rg16f"). All tiers use the same
// format: the first one that the device supports for the uses of the image in every tier. So the image keeps
// its content when the tier changes. common_formats() in load_graph.h makes the choice once for all tiers.
#pragma once

#include <string>
#include <vector>

#include "weft/load/load_graph.h"

namespace weft {

// One tier of a graph: its passes and resources, and its shaders, which determine how images are used.
struct TierVariant {
    GraphDesc desc;
    ShaderCatalog shaders;
};

// Parses each tier and compiles its shaders. A tier with faults is left out, because loading this tier will
// report the faults. The tier "" is the graph without a tier.
[[nodiscard]] std::vector<TierVariant> load_tiers(const JsonDoc& document,
                                                  const std::vector<std::string>& tiers, LoadInput input);
// Returns the input without the observed resources, the parameters and the debug view of the request.
[[nodiscard]] LoadInput as_written(LoadInput input);

// Returns the formats to skip for the tier of `input`; `own` is this tier. `own` is resolved with the
// parameters and observed resources of the request; the other tiers are resolved without them.
[[nodiscard]] SkippedFormats formats_with_others(const JsonDoc& document, const TierVariant& own,
                                                 const LoadInput& input);

}  // namespace weft
