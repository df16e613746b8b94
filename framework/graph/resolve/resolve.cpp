#include "graph/resolve/resolve_context.h"

namespace weft {

namespace {

void run_steps(ResolveState& state) {
    resolve_values(state);
    resolve_resources(state);
    if (!state.over_limit) declare_passes(state);
    // Of a graph that is too large, nothing more is worth saying.
    if (state.over_limit) return;
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
    if (state.errors.empty()) weigh_plan(state);
    warn_unused(state);
    weigh_params(state);
    warn_useless(state);
}

void report_steps(ResolveState& state, SourceLoc loc) {
    const size_t tiers = state.input.graph.tiers.size();
    Diagnostic d = state.input.graph.sources.error(
        loc, "W125",
        "the graph takes more than " + std::to_string(state.most_steps()) +
            " steps to resolve, counted up to here" +
            (tiers > 0 ? ": a part of " + std::to_string(state.input.limits.steps) + " for each tier" : ""));
    d.help.push_back("use fewer passes and ports, wider ranges of mips and layers, or shorter expressions, " +
                     raise_limit_text("graph.steps"));
    state.errors.push_back(std::move(d));
}

}  // namespace

Result<ResolvedGraph> resolve(const ResolveInput& input, Diagnostics& warnings) {
    ResolveState state{.input = input, .warnings = warnings};
    state.graph.name = input.graph.name;
    state.graph.output_extent = input.output_extent;
    try {
        run_steps(state);
    } catch (const TooManyErrors&) {
        state.errors.back().help.push_back("only the first " + std::to_string(state.errors.size()) +
                                           " errors are shown");
    } catch (const StepsUsedUp& end) {
        report_steps(state, end.loc);
    }
    if (state.hidden_warnings > 0)
        warnings.back().help.push_back("and " + std::to_string(state.hidden_warnings) +
                                       " more warnings like these");
    if (!state.errors.empty()) return std::move(state.errors);
    state.graph.sources = input.graph.sources;
    return std::move(state.graph);
}

}  // namespace weft
