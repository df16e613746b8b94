// Purpose: finds the mips, layers and aspects that a reference such as "hiz.mip(1..3)" selects. Private to
// bind().
#pragma once

#include <optional>

#include "graph/resolve/bind.h"

namespace weft {

// Returns the range, or nullopt if an error in the reference was reported, now or earlier. Errors: W105.
[[nodiscard]] std::optional<SubresourceRange> find_range(PassId pass, const RefDesc& ref,
                                                         const ResourceDecl& resource,
                                                         const Evaluator& evaluator, Suspects& suspects,
                                                         PassReporter& report);

}  // namespace weft
