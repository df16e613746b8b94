// The output is what the graph is there for: somebody must write it.
#include <algorithm>

#include "graph/resolve/resolve_presence.h"

namespace weft {

void check_output(ResolveState& state) {
    const ResourceId output = state.graph.output;
    // The pass that would write it may have a fault that was reported.
    if (output == kNoId || !state.errors.empty()) return;
    const ResourceWork& work = state.resources[output];
    if (work.suspect_shape || work.suspect_writers) return;
    const auto writes_it = [&](const UseDecl& use) { return use.resource == output && writes(use.access); };
    for (const PassDecl& pass : state.graph.passes)
        if (std::ranges::any_of(pass.uses, writes_it)) return;
    const ResourceDecl& decl = state.graph.resources[output];
    Diagnostic& d = state.error(decl.loc, "W184", "no pass writes the output " + quoted(decl.name));
    if (const PassDesc* dropped = dropped_writer(state, decl.name))
        add_help(d, "pass " + quoted(dropped->name) + ", which would write it, is left out");
    add_help(d, "let a pass write it: \"out\": [" + quoted(decl.name) +
                    "]; or, in a graph that only delivers "
                    "resources, remove the import");
}

}  // namespace weft
