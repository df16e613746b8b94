// `weft diff`: prints the differences between the plans of two graph files.
#include "viewer/commands/commands.h"
#include "viewer/commands/offline_graph.h"
#include "viewer/options/graph_name.h"
#include "viewer/output/output.h"
#include "viewer/output/report.h"
#include "weft/report/plan_diff.h"

namespace weft::viewer {
namespace {

// Compiles one of the two arguments of `weft diff`. The argument is FILE or FILE:TIER.
Result<OfflinePlan> compile_side(const std::string& side, OfflineOptions options, Diagnostics& warnings) {
    const GraphName name = read_graph_name(side);
    if (!name.tier.empty()) options.request.tier = name.tier;
    return compile_offline(name.graph, options, warnings);
}

}  // namespace

ExitCode run_diff(const DiffOptions& options) {
    Diagnostics warnings;  // The command does not print warnings of the graphs; `weft check` prints them.
    Result<OfflinePlan> from = compile_side(options.from, options.offline, warnings);
    Result<OfflinePlan> to = compile_side(options.to, options.offline, warnings);
    Diagnostics errors;
    for (Result<OfflinePlan>* made : {&from, &to})
        if (!*made) errors.insert(errors.end(), made->errors().begin(), made->errors().end());
    if (!errors.empty()) {
        report(errors);
        return exit_code_for(errors);
    }
    const PlanDiff diff = diff_plans(from->plan, to->plan);
    return print_data(options.json ? plan_diff_to_json(diff) : plan_diff_to_text(diff));
}

}  // namespace weft::viewer
