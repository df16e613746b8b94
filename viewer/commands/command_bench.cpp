// `weft bench compile`: measures the time of the graph compiler, the times of its stages, and the quality of
// the plans (memory, barriers).
#include <unistd.h>

#include <chrono>
#include <cstdio>

#include "viewer/bench/compile_bench.h"
#include "viewer/commands/commands.h"
#include "viewer/commands/load_settings.h"
#include "viewer/output/output.h"
#include "viewer/output/progress_text.h"

namespace weft::viewer {

ExitCode run_bench_compile(const BenchOptions& options) {
    ProgressText text("compiling generated graphs", isatty(STDERR_FILENO) != 0);
    const auto start = std::chrono::steady_clock::now();
    const std::vector<CompiledGraph> graphs =
        measure_compile(options, load_settings({}, {}), [&](uint32_t done) {
            const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
            std::fputs(text.at(elapsed.count(), "graphs", done, options.seeds).c_str(), stderr);
        });
    std::fputs(text.finish().c_str(), stderr);
    return print_data(options.json ? compile_bench_json(options, graphs)
                                   : compile_bench_text(options, graphs));
}

}  // namespace weft::viewer
