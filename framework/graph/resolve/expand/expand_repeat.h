// Purpose: the passes that one description stands for. Private to expand().
#pragma once

#include "graph/resolve/expand.h"

namespace weft {

struct PassInstance {
    std::string name;
    std::map<std::string, double> indices;
};

// Counts of the whole graph so far, which limits bound.
struct RepeatCounts {
    uint64_t steps = 0;
    uint64_t passes = 0;  // those that `if` leaves out are counted too
};

// Extends `counts` and the expansion's `dropped`, `faulty`, `tried_ports`, `too_large` and `suspects`.
[[nodiscard]] std::vector<PassInstance> repeat_pass(const ResolveInput& input, const Evaluator& evaluator,
                                                    const Shapes& shapes, const PassDesc& desc,
                                                    RepeatCounts& counts, Expansion& expansion,
                                                    Reporter& reporter);

}  // namespace weft
