// Passes that take turns, one a frame: what they write must still be there in the frames between.
#include "graph/resolve_context.h"

namespace weft {
namespace {

bool stays(const ResourceDecl& resource) {
    return resource.lifetime == ResourceLifetime::persistent && resource.history == 0;
}

void check_repeat(ResolveState& state, const PassDesc& desc) {
    const bool none = desc.per_frame.empty() || desc.per_frame.text == "false";
    if (none || !desc.repeat.empty()) return;
    Diagnostic& d = state.error(desc.per_frame_loc, "W124",
                                "pass " + quoted(desc.name) + " says \"perFrame\" but repeats nothing");
    add_help(d, "say what takes turns: \"repeat\": { \"i\": \"0..5\" }");
}

void check_outputs(ResolveState& state, PassId pass) {
    const IndexScope scope(state, pass);
    for (const UseDecl& use : state.graph.passes[pass].uses) {
        const ResourceDecl& resource = state.graph.resources[use.resource];
        if (!writes(use.access) || stays(resource)) continue;
        Diagnostic& d =
            state.pass_error(pass, use.loc, "W124",
                             "pass " + quoted(state.author_name(pass)) + " writes a part of " +
                                 quoted(resource.name) + " each frame, but its content does not stay");
        if (resource.lifetime == ResourceLifetime::imported)
            add_help(d, "write a resource with \"keep\": true, and copy that");
        else
            add_help(d, "add \"keep\": true to resource " + quoted(resource.name) +
                            (resource.history > 0 ? " instead of its history" : ""));
    }
}

}  // namespace

void check_turns(ResolveState& state) {
    for (const auto& [name, desc] : state.input.graph.passes) check_repeat(state, desc);
    for (PassId id = 0; id < state.passes.size(); ++id)
        if (state.graph.passes[id].turns > 0) check_outputs(state, id);
}

}  // namespace weft
