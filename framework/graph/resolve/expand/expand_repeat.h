// Purpose: makes the passes of one pass description: one for each combination of the values of its repeat
// indices, except those that `if` removes. Private to expand().
#pragma once

#include "graph/resolve/expand.h"

namespace weft {

// One pass of the repeat: its name, for example "blur#2", and the values of the repeat indices by name.
struct PassInstance {
    std::string name;
    std::map<std::string, double> indices;
};

// Counts over all pass descriptions of the graph. Each count has a limit.
struct RepeatCounts {
    // Number of loop iterations so far, in all levels of nested repeats.
    uint64_t steps = 0;
    // Number of passes made so far, including passes that `if` removes.
    uint64_t passes = 0;
};

// Returns the passes that one description results in. If `unites_views` is true, one pass draws all views of
// the key "views", and its index "view" is 0. After reporting an error, returns an empty list. Updates
// `counts` and these members of the expansion: `dropped`, `faulty`, `tried_ports`, `too_large`, `suspects`.
[[nodiscard]] std::vector<PassInstance> repeat_pass(const ResolveInput& input, const Values& values,
                                                    const Evaluator& evaluator, const Shapes& shapes,
                                                    const PassDesc& desc, bool unites_views,
                                                    RepeatCounts& counts, Expansion& expansion,
                                                    Reporter& reporter);

}  // namespace weft
