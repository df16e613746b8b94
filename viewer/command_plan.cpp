#include <cstdio>

#include "commands.h"
#include "files.h"
#include "graph/plan_dump.h"
#include "offline_graph.h"

namespace weft::viewer {

ExitCode run_plan(const PlanOptions& options) {
    Result<DeviceProfile> profile = load_profile(options.profile);
    Diagnostics warnings;
    Result<FramePlan> plan =
        profile ? compile_offline(options.file, *profile, options.size, options.params, warnings)
                : Result<FramePlan>(profile.take_errors());
    report(warnings);
    if (!plan) {
        report(plan.errors());
        return exit_code_for(plan.errors());
    }
    const std::string text = options.format == "json"  ? plan_to_json(*plan)
                             : options.format == "dot" ? plan_to_dot(*plan)
                                                       : plan_to_text(*plan);
    if (options.output.empty()) {
        std::fputs(text.c_str(), stdout);
        return ExitCode::ok;
    }
    if (Status s = write_file(options.output, text); !s) {
        report(s.errors());
        return ExitCode::failed;
    }
    return ExitCode::ok;
}

}  // namespace weft::viewer
