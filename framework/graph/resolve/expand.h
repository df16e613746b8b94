// Purpose: the stage of resolve() that finds the passes of the graph. A description results in one pass, in
// several (`repeat`), or in none (`if`); an observed reference becomes a separate pass. Each gets its kind,
// its shader and its fixed-function state. Errors: W106, W107, W109, W115, W125, W177, W187, and those of
// references.
#pragma once

#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "graph/resolve/evaluator.h"

namespace weft {

// A pass before its ports are bound.
struct PassDraft {
    PassDecl decl;  // everything known without ports: name, kind, state, frames in which it runs
    const PassDesc* desc = nullptr;
    std::map<std::string, double> indices = {};  // of its repeat
    uint32_t instance = 0;                       // its index within the repeat
    const ShaderInterface* shader = nullptr;     // null: it has none, or that was reported
    const PassType* custom = nullptr;
    bool is_observer = false;
};

struct Expansion {
    std::vector<PassDraft> passes;  // sorted by name
    // By the name that the author gave: the passes of a repeat, in order.
    std::map<std::string, std::vector<PassId>, std::less<>> instances = {};
    std::map<std::string, const PassDesc*, std::less<>> dropped = {};  // removed by `if` or an empty repeat
    std::set<std::string, std::less<>> faulty = {};  // reported: it is unknown whether they run
    std::map<std::string, PassDesc> observers = {};  // drafts point into it
    uint64_t tried_ports = 0;                        // includes those of passes that `if` removes
    bool too_large = false;                          // reported
    Suspects suspects;
};
[[nodiscard]] Expansion expand(const ResolveInput& input, const Values& values, const Shapes& shapes,
                               Reporter& reporter);

}  // namespace weft
