#include <cstdio>

#include "commands.h"
#include "files.h"
#include "format_schema.h"
#include "graph_schema.h"

namespace weft::viewer {

ExitCode run_schema(const SchemaOptions& options) {
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
    if (options.output.empty()) {
        std::fputs(text.c_str(), stdout);
        return ExitCode::ok;
    }
    const Status written = write_file(options.output, text);
    if (written) return ExitCode::ok;
    report(written.errors());
    return ExitCode::failed;
}

}  // namespace weft::viewer
