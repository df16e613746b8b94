#include <algorithm>
#include <cstdio>

#include <unistd.h>

#include "viewer/files/near_files.h"
#include "viewer/output/report.h"
#include "viewer/output/terminal_colors.h"

namespace weft::viewer {
namespace {

// At most this many errors and this many warnings are printed. A file may have an error in every line.
constexpr size_t kMostShown = 200;

void print(Diagnostic d, bool colors) {
    add_near_files(d);
    std::fprintf(stderr, "%s\n", (colors ? colored_text(d) : to_text(d)).c_str());
}

}  // namespace

void report(const Diagnostics& diagnostics) {
    const bool colors = wants_colors(STDERR_FILENO);
    size_t errors = 0, warnings = 0, hidden = 0;
    for (const Diagnostic& d : diagnostics) {
        const size_t seen = d.severity == Severity::error ? ++errors : ++warnings;
        if (seen <= kMostShown) print(d, colors);
        if (seen > kMostShown) ++hidden;
    }
    if (hidden > 0) std::fprintf(stderr, "weft: %zu more errors and warnings are not shown\n", hidden);
}

// Prints the text directly instead of through a Diagnostic, because creating a Diagnostic needs memory.
void report_out_of_memory() {
    std::fputs(
        "error[X571]: memory ran out\n"
        "  help: close other programs, or use a smaller --size, scene or graph\n",
        stderr);
}

ExitCode exit_code_for(const Diagnostics& errors) {
    const auto it = std::find_if(errors.begin(), errors.end(),
                                 [](const Diagnostic& d) { return d.severity == Severity::error; });
    if (it == errors.end() || it->code.empty()) return ExitCode::failed;
    if (it->code == "V407" || it->code == "V408") return ExitCode::lost;
    if (it->code.starts_with("V40")) return ExitCode::no_device;
    if (it->code.starts_with("X52")) return ExitCode::usage;
    if (it->code.starts_with("X53") || it->code.starts_with("X56")) return ExitCode::invalid_input;
    if (it->code == "W161" || it->code == "W189") return ExitCode::mismatch;
    if (it->code == "W162") return ExitCode::validation;
    const char kind = it->code.front();
    return kind == 'W' || kind == 'S' ? ExitCode::invalid_input : ExitCode::failed;
}

}  // namespace weft::viewer
