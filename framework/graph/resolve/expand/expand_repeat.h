// Purpose: makes all passes of one pass description: one for each value of its repeat. Private to expand().
#pragma once

#include "graph/resolve/expand.h"

namespace weft {

struct PassInstance {
    std::string name;
    std::map<std::string, double> indices;
};

// Numbers counted over the whole graph, which have limits.
struct RepeatCounts {
    uint64_t steps = 0;
    // Number of passes made so far, including passes that `if` removes.
    uint64_t passes = 0;
};

// Returns the passes that one description results in. Adds to `counts`, and to these members of the
// expansion: `dropped`, `faulty`, `tried_ports`, `too_large` and `suspects`.
[[nodiscard]] std::vector<PassInstance> repeat_pass(const ResolveInput& input, const Evaluator& evaluator,
                                                    const Shapes& shapes, const PassDesc& desc,
                                                    RepeatCounts& counts, Expansion& expansion,
                                                    Reporter& reporter);

}  // namespace weft
