// Purpose: resources with `"keep": "shared"`. All tiers use the same memory for such a resource, so it must
// have the same shape in all tiers, and its usage is the union of the usages in all tiers. A tier that does
// not have the resource, or that gives it another value of `keep`, does not count.
#pragma once

#include "load/tier_formats.h"

namespace weft {

// Returns the usages of the shared resources of the tier `own`. Errors: W198 if the tiers disagree about the
// shape. The other tiers are loaded only if there is a shared resource.
[[nodiscard]] Result<SharedUsages> agree_on_shared(const JsonDoc& document, const TierVariant& own,
                                                   const LoadInput& input, const SkippedFormats& skipped);
// Gives the shared resources of a graph their usages.
void set_usages(const SharedUsages& usages, ResolvedGraph& graph);

}  // namespace weft
