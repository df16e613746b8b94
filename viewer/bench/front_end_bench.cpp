#include "viewer/bench/front_end_bench.h"

#include <algorithm>
#include <chrono>
#include <stdexcept>
#include <string>
#include <utility>

#include "graph/parse/parse.h"
#include "graph/resolve/resolve.h"
#include "graph/syntax/merge.h"
#include "graph/syntax/read_graph.h"
#include "viewer/bench/bench_file.h"
#include "weft/check/check_plan.h"

namespace weft::viewer {
namespace {

using Clock = std::chrono::steady_clock;

double us_since(Clock::time_point start) {
    return std::chrono::duration<double, std::micro>(Clock::now() - start).count();
}

// Runs one stage and adds its time to `times`.
template <class Stage>
auto timed(const char* name, std::vector<StageTime>& times, Stage stage) {
    const Clock::time_point start = Clock::now();
    auto result = stage();
    times.push_back({name, us_since(start)});
    if (!result) throw std::logic_error("a generated graph file has an error: " + to_text(result.errors()));
    return std::move(result).value();
}

std::vector<StageTime> run_once(const std::string& text, const ShaderCatalog& shaders,
                                const DeviceProfile& profile) {
    const GraphLimits limits = bench_limits();
    const FileReader reader = [&text](const std::string&) { return std::optional(text); };
    std::vector<StageTime> times;
    JsonDoc document =
        timed("read", times, [&] { return read_graph("bench.json", reader, {.limits = limits}); });
    const JsonDoc merged = timed("merge", times, [&] { return merge(std::move(document)); });
    const GraphDesc desc = timed("parse", times, [&] { return parse(merged, limits); });
    const PassCatalog no_passes;
    const ImportCatalog no_imports;
    Diagnostics warnings;
    [[maybe_unused]] const ResolvedGraph graph = timed("resolve", times, [&] {
        return resolve({.graph = desc,
                        .passes = no_passes,
                        .shaders = shaders,
                        .imports = no_imports,
                        .profile = profile,
                        .request = {},
                        .limits = limits},
                       warnings);
    });
    return times;
}

}  // namespace

std::vector<StageTime> measure_front_end(const ResolvedGraph& graph) {
    const std::string text = bench_file_text(graph);
    const ShaderCatalog shaders = bench_shaders();
    const DeviceProfile profile = bench_profile();
    const std::vector<StageTime> first = run_once(text, shaders, profile);
    const std::vector<StageTime> second = run_once(text, shaders, profile);
    return total_us(first) <= total_us(second) ? first : second;
}

double measure_check_us(const FramePlan& plan) {
    double least = 0;
    for (int run = 0; run < 2; ++run) {
        const Clock::time_point start = Clock::now();
        const Diagnostics faults = check_plan(plan);
        const double us = us_since(start);
        if (!faults.empty()) throw std::logic_error("a generated plan has an error: " + to_text(faults));
        least = run == 0 ? us : std::min(least, us);
    }
    return least;
}

double total_us(const std::vector<StageTime>& stages) {
    double total = 0;
    for (const StageTime& stage : stages) total += stage.us;
    return total;
}

}  // namespace weft::viewer
