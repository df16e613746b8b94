// Purpose: the results of the first stages of resolve(), which all later stages read.
#pragma once

#include "graph/resolve/expand.h"
#include "graph/resolve/pass_reporter.h"

namespace weft {

struct Declared {
    const ResolveInput& input;
    const Values& values;
    const Shapes& shapes;
    const Expansion& expansion;

    // For expressions outside of passes.
    [[nodiscard]] Evaluator evaluator(const Suspects& suspects, Reporter& reporter) const {
        return {values, shapes, suspects, reporter};
    }
    // For expressions of one pass.
    [[nodiscard]] Evaluator evaluator(PassId pass, const Suspects& suspects, Reporter& reporter) const {
        const PassDraft& draft = expansion.passes[pass];
        return evaluator(suspects, reporter).in_repeat(draft.indices, draft.instance > 0);
    }
    [[nodiscard]] const std::string& author_name(PassId pass) const {
        return expansion.passes[pass].desc->name;
    }
    [[nodiscard]] const std::string& pass_name(PassId pass) const { return expansion.passes[pass].decl.name; }
    [[nodiscard]] const std::string& resource_name(ResourceId id) const { return shapes.resources[id].name; }
};

// "pass \"blur#2\"" or "the observer": the subject of a message.
[[nodiscard]] std::string name_reader(const PassDraft& pass);
// The names of all passes in the graph, including those that `if` removes.
[[nodiscard]] std::vector<std::string> described_pass_names(const GraphDesc& graph);

}  // namespace weft
