#include "graph/resolve_context.h"

namespace weft {

Result<ResolvedGraph> resolve(const ResolveInput& input, Diagnostics& warnings) {
    ResolveState state{.input = input, .warnings = warnings};
    state.graph.name = input.graph.name;
    state.graph.output_extent = input.output_extent;

    resolve_values(state);
    resolve_resources(state);
    if (!state.over_limit) declare_passes(state);
    // Of a graph that is too large, nothing more is worth saying.
    if (state.over_limit) return std::move(state.errors);
    bind_ports(state);
    choose_formats(state);
    check_interfaces(state);
    check_turns(state);
    resolve_versions(state);
    resolve_attachments(state);
    check_clear_values(state);
    check_output(state);
    resolve_dispatches(state);
    resolve_blocks(state);
    check_custom_passes(state);
    warn_unused(state);
    weigh_params(state);
    warn_useless(state);

    if (!state.errors.empty()) return std::move(state.errors);
    state.graph.sources = input.graph.sources;
    return std::move(state.graph);
}

}  // namespace weft
