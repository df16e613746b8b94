// Checks passes with `repeat` and `perFrame`. In each frame after frame 0, only some passes of the repeat
// run. The results of the other passes come from earlier frames. So all passes of the repeat must write
// resources that keep their content between frames.
#include "graph/resolve/checks.h"
#include "graph/resolve/fault_text.h"

namespace weft {
namespace {

bool stays(const ResourceDecl& resource) {
    return resource.lifetime == ResourceLifetime::persistent && resource.history == 0;
}

void check_repeat(const PassDesc& desc, Reporter& reporter) {
    const bool none = desc.per_frame.empty() || desc.per_frame.text == "false";
    if (none || !desc.repeat.empty()) return;
    Diagnostic& d = reporter.error(desc.per_frame_loc, "W124",
                                   "pass " + quote(desc.name) + " has \"perFrame\", but no \"repeat\"");
    add_help(
        d, "remove \"perFrame\", or add a repeat to distribute over frames: \"repeat\": { \"i\": \"0..5\" }");
}

void check_outputs(const Declared& declared, const FormattedGraph& graph, PassId pass, PassReporter& report) {
    for (const UseDecl& use : graph.passes[pass].uses) {
        const ResourceDecl& resource = graph.resources[use.resource];
        if (!writes(use.access) || stays(resource)) continue;
        Diagnostic& d =
            report.error(pass, use.loc, "W124",
                         "pass " + quote(declared.author_name(pass)) +
                             " runs in some frames only (\"perFrame\") and writes " + quote(resource.name) +
                             ", but this resource does not keep its content between frames");
        if (resource.lifetime == ResourceLifetime::imported)
            add_help(d, "write a resource with \"keep\": true, and copy its content");
        else
            add_help(d, "add \"keep\": true to resource " + quote(resource.name) +
                            (resource.history > 0 ? " instead of its history" : ""));
    }
}

}  // namespace

Suspects check_frame_slices(const Declared& declared, const FormattedGraph& graph, Suspects suspects,
                            Reporter& reporter) {
    PassReporter report(declared.shapes, declared.expansion, suspects, reporter);
    for (const auto& [name, desc] : declared.input.graph.passes) check_repeat(desc, reporter);
    for (PassId id(0); id < graph.passes.size(); ++id)
        if (declared.expansion.passes[id].decl.frame_slices > 0) check_outputs(declared, graph, id, report);
    return suspects;
}

}  // namespace weft
