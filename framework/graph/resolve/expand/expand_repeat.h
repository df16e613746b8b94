// Purpose: makes the passes of one description. Private to expand().
#pragma once

#include "graph/resolve/expand.h"

namespace weft {

struct PassInstance {
    std::string name;
    std::map<std::string, double> indices;
};

// Counts of the whole graph so far, which have limits.
struct RepeatCounts {
    uint64_t steps = 0;
    uint64_t passes = 0;  // includes passes that `if` removes
};

// Extends `counts` and the expansion's `dropped`, `faulty`, `tried_ports`, `too_large` and `suspects`.
[[nodiscard]] std::vector<PassInstance> repeat_pass(const ResolveInput& input, const Evaluator& evaluator,
                                                    const Shapes& shapes, const PassDesc& desc,
                                                    RepeatCounts& counts, Expansion& expansion,
                                                    Reporter& reporter);

}  // namespace weft
