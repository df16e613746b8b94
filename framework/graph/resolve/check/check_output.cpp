#include <algorithm>

#include "graph/resolve/checks.h"
#include "graph/resolve/dropped_writer.h"
#include "graph/resolve/fault_text.h"

namespace weft {

void check_output(const Declared& declared, const VersionedGraph& graph, const Suspects& suspects,
                  Reporter& reporter) {
    const ResourceId output = declared.shapes.output;
    // After any error there is no check, because the pass that should write the output may be the one with
    // the error.
    if (output == kNoId || reporter.has_errors()) return;
    if (suspects.shapes[output] || suspects.writers[output]) return;
    const auto writes_it = [&](const UseDecl& use) { return use.resource == output && writes(use.access); };
    for (const BoundPass& pass : graph.passes)
        if (std::ranges::any_of(pass.uses, writes_it)) return;
    const ResourceDecl& decl = graph.resources[output];
    Diagnostic& d = reporter.error(decl.loc, "W184", "no pass writes the output " + quote(decl.name));
    if (const PassDesc* dropped = dropped_writer(declared.expansion, decl.name, reporter))
        add_help(
            d, "pass " + quote(dropped->name) +
                   " would write the output, but is removed: its \"if\" is false or its \"repeat\" is empty");
    add_help(d, "let a pass write the output: \"out\": [" + quote(decl.name) +
                    "]; or remove the import, if the graph needs no output image");
}

}  // namespace weft
