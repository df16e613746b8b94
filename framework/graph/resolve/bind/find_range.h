// Purpose: the mips, layers and aspects that a reference names. Private to bind().
#pragma once

#include <optional>

#include "graph/resolve/bind.h"

namespace weft {

// nullopt: reported, or suspect. Errors: W105.
[[nodiscard]] std::optional<SubresourceRange> find_range(PassId pass, const RefDesc& ref,
                                                         const ResourceDecl& resource,
                                                         const Evaluator& evaluator, Suspects& suspects,
                                                         PassReporter& report);

}  // namespace weft
