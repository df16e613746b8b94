#include "viewer/commands/commands.h"
#include "viewer/output/output.h"
#include "viewer/output/report.h"
#include "viewer/schema/format_schema.h"
#include "viewer/schema/graph_schema.h"

namespace weft::viewer {

ExitCode run_schema(const SchemaOptions& options) {
    if (const ExitCode code = check_outputs({options.output}, {options.file}); code != ExitCode::ok)
        return code;
    std::string text;
    if (options.file.empty()) {
        text = format_schema();
    } else {
        const Result<GraphNames> names = gather_names(options);
        if (!names) {
            report(names.errors());
            return exit_code_for(names.errors());
        }
        text = graph_schema(*names);
    }
    return output_data(options.output, text);
}

}  // namespace weft::viewer
