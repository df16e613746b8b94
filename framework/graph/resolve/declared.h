// Purpose: collects the results of the first stages of resolve(), which all later stages read.
#pragma once

#include "graph/resolve/expand.h"
#include "graph/resolve/pass_reporter.h"

namespace weft {

struct Declared {
    const ResolveInput& input;
    const Values& values;
    const Shapes& shapes;
    const Expansion& expansion;

    // Returns an evaluator for expressions that belong to no pass, for example the size of a resource.
    [[nodiscard]] Evaluator evaluator(const Suspects& suspects, Reporter& reporter) const {
        return {values, shapes, suspects, reporter};
    }
    // Returns an evaluator for expressions of one pass, which may name the indices of its repeat.
    [[nodiscard]] Evaluator evaluator(PassId pass, const Suspects& suspects, Reporter& reporter) const {
        const PassDraft& draft = expansion.passes[pass];
        return evaluator(suspects, reporter).in_repeat(draft.indices, draft.instance > 0);
    }
    // The two names of a pass that a repeat made: author_name() is the name in the graph file, "blur", and
    // pass_name() is the name with the index, "blur#2". For other passes, both names are the same.
    [[nodiscard]] const std::string& author_name(PassId pass) const {
        return expansion.passes[pass].desc->name;
    }
    [[nodiscard]] const std::string& pass_name(PassId pass) const { return expansion.passes[pass].decl.name; }
    [[nodiscard]] const std::string& resource_name(ResourceId id) const { return shapes.resources[id].name; }
};

// Returns the name of a reading pass for the beginning of a message: `pass "blur#2"`, or "the observer" for a
// pass that reads back an observed resource.
[[nodiscard]] std::string name_reader(const PassDraft& pass);
// Returns the names of all passes in the graph file, including passes that `if` removes.
[[nodiscard]] std::vector<std::string> list_pass_names(const GraphDesc& graph);

}  // namespace weft
