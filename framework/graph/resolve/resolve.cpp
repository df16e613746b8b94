#include "graph/resolve/resolve.h"

#include "graph/resolve/assemble.h"
#include "graph/resolve/carry/carry_passes.h"
#include "graph/resolve/checks.h"
#include "graph/resolve/live/follow_areas.h"
#include "graph/resolve/lower/mixed_layers.h"
#include "graph/resolve/shape/shape_export.h"
#include "graph/resolve/switches/make_variants.h"

namespace weft {

namespace {

VersionedGraph connect_passes(const Declared& declared, Reporter& reporter) {
    FormattedGraph formatted = choose_formats(declared, bind(declared, reporter), reporter);
    set_export_states(declared.input.request, formatted.resources);
    check_files(declared, formatted, reporter);
    Suspects suspects = check_interfaces(declared, formatted, reporter);
    suspects = check_frame_slices(declared, formatted, std::move(suspects), reporter);
    return version(declared, std::move(formatted), std::move(suspects), reporter);
}

ResolvedGraph run_stages(const ResolveInput& input, Reporter& reporter) {
    const Values values = evaluate(input, reporter);
    const Shapes shapes = shape_resources(input, values, reporter);
    const size_t warnings = reporter.warning_count();
    Expansion expansion = expand(input, values, shapes, reporter);
    if (expansion.too_large) return {};
    // `declared` keeps a reference to `expansion`, so it also sees the new expansion below.
    const Declared declared{input, values, shapes, expansion};
    VersionedGraph graph = connect_passes(declared, reporter);
    if (const SeparateViews mixed = find_mixed_layers(declared, graph, reporter); !mixed.empty()) {
        // The content with which each layer begins is known only now. A pass that draws a single view has no
        // mixed layers, so it is enough to repeat these stages once.
        reporter.drop_warnings(warnings);
        expansion = expand(input, values, shapes, reporter, mixed);
        graph = connect_passes(declared, reporter);
    }
    const Attachments attachments = attach(declared, graph, reporter);
    check_clear_values(declared, graph, attachments.suspects, reporter);
    check_output(declared, graph, attachments.suspects, reporter);
    const Dispatches dispatches = size_dispatches(declared, graph, attachments.suspects, reporter);
    const Blocks blocks = fill_blocks(declared, graph, dispatches.suspects, reporter);
    ResolvedGraph resolved = assemble(declared, graph, attachments, dispatches, blocks);
    resolved = make_variants(declared, graph, std::move(resolved), reporter);
    resolved = follow_areas(declared, graph, blocks.suspects, std::move(resolved), reporter);
    resolved = check_custom_passes(declared, std::move(resolved), blocks.suspects, reporter);
    weigh_plan(resolved, reporter);
    warn_unused(declared, reporter);
    resolved.params = weigh_params(input, std::move(resolved.params), reporter);
    warn_useless(declared, graph, resolved, blocks.suspects, reporter);
    warn_restless(declared, resolved, reporter);
    return remove_idle_carries(std::move(resolved));
}

}  // namespace

Result<ResolvedGraph> resolve(const ResolveInput& input, Diagnostics& warnings) {
    Reporter reporter(input.graph, input.limits.steps, warnings);
    ResolvedGraph graph;
    try {
        graph = run_stages(input, reporter);
    } catch (const ResolveStopped&) {
        // The reporter has already added an error that explains why resolving was stopped.
    }
    Diagnostics errors = reporter.finish();
    if (!errors.empty()) return errors;
    graph.sources = input.graph.sources;
    return graph;
}

}  // namespace weft
