#include "viewer/commands/commands.h"
#include "viewer/commands/offline_graph.h"
#include "viewer/output/output.h"
#include "viewer/output/report.h"
#include "weft/cooked_graph.h"
#include "weft/report/plan_dump.h"

namespace weft::viewer {
namespace {

std::string in_format(const PlanOptions& options, const OfflinePlan& made) {
    if (options.format == "json") return plan_to_json(made.plan);
    if (options.format == "dot") return plan_to_dot(made.plan);
    if (options.format == "html")
        return plan_to_html(made.plan, {options.file, options.offline.request.tier, made.profile.name});
    if (options.format == "cooked") {
        const std::vector<std::byte> bytes = cook(made.plan.graph, made.shaders);
        return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
    }
    return plan_to_text(made.plan, &made.profile);
}

}  // namespace

ExitCode run_plan(const PlanOptions& options) {
    if (const ExitCode code = check_outputs({options.output}, {options.file}); code != ExitCode::ok)
        return code;
    Diagnostics warnings;
    const Result<OfflinePlan> made = compile_offline(options.file, options.offline, warnings);
    report(warnings);
    if (!made) {
        report(made.errors());
        return exit_code_for(made.errors());
    }
    return output_data(options.output, in_format(options, *made));
}

}  // namespace weft::viewer
