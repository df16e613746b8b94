#include <cstdio>

#include "commands.h"
#include "files.h"
#include "graph/plan_dump.h"
#include "offline_graph.h"

namespace weft::viewer {

ExitCode run_plan(const PlanOptions& options) {
    Diagnostics warnings;
    const Result<OfflinePlan> made = compile_offline(options.file, options.offline, warnings);
    report(warnings);
    if (!made) {
        report(made.errors());
        return exit_code_for(made.errors());
    }
    const std::string text = options.format == "json"  ? plan_to_json(made->plan)
                             : options.format == "dot" ? plan_to_dot(made->plan)
                                                       : plan_to_text(made->plan, &made->profile);
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
