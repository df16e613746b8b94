// `weft bench compile`: measures the total time of the graph compiler, the time of its stages, and the
// quality of the plan (memory, barriers).
#include <algorithm>
#include <chrono>
#include <nlohmann/json.hpp>

#include "graph/compile/bench_graph.h"
#include "viewer/commands/commands.h"
#include "viewer/output/formatted.h"
#include "viewer/output/output.h"
#include "weft/compile.h"

namespace weft::viewer {
namespace {

using Json = nlohmann::ordered_json;
using Clock = std::chrono::steady_clock;

constexpr int kWarmRuns = 11;
constexpr double kMib = 1048576.0;

double us_since(Clock::time_point start) {
    return std::chrono::duration<double, std::micro>(Clock::now() - start).count();
}

struct BenchResult {
    double cold_us = 0, warm_min_us = 0, warm_median_us = 0;
    std::vector<StageTime> stages;  // Times of the compiler's stages in the fastest run after the first.
    FramePlan plan;
};

BenchResult measure(const ResolvedGraph& graph, const CompileOptions& options) {
    const MemoryNeeds needs = bench_needs(graph);
    BenchResult result;
    std::vector<StageTime> stages;
    const auto timed = [&] {
        const Clock::time_point start = Clock::now();
        result.plan = compile(graph, needs, options, &stages);
        return us_since(start);
    };
    result.cold_us = timed();
    std::vector<double> warm;
    for (int run = 0; run < kWarmRuns; ++run) {
        warm.push_back(timed());
        if (warm.back() == *std::min_element(warm.begin(), warm.end())) result.stages = stages;
    }
    std::sort(warm.begin(), warm.end());
    result.warm_min_us = warm.front();
    result.warm_median_us = warm[warm.size() / 2];
    return result;
}

Json bench_json(const BenchOptions& options, const BenchResult& result) {
    const FramePlan& plan = result.plan;
    Json candidates = Json::array();
    for (const ScheduleCandidate& c : plan.schedule.candidates)
        candidates.push_back({{"name", c.name},
                              {"peak_live_bytes", c.peak_live_bytes},
                              {"batches", c.barrier_batches},
                              {"queue_switches", c.queue_switches}});
    Json stages = Json::object();
    for (const StageTime& time : result.stages) stages[time.stage] = time.us;
    return {{"passes", options.passes},
            {"shape", options.shape},
            {"seed", options.seed},
            {"queues", options.queues},
            {"cold_us", result.cold_us},
            {"warm_us", {{"min", result.warm_min_us}, {"median", result.warm_median_us}}},
            {"stages_us", stages},
            {"peak_live_bytes", plan.memory.peak_live_bytes},
            {"heap_bytes", plan.memory.heap_bytes},
            {"candidates", candidates},
            {"chosen", plan.schedule.chosen},
            {"barriers", plan.barriers.emitted}};
}

std::string to_text(const BenchOptions& options, const BenchResult& result) {
    const MemoryPlan& memory = result.plan.memory;
    std::string text =
        formatted("%u passes, %s, seed %u, %u queue%s\n", options.passes, options.shape.c_str(), options.seed,
                  options.queues, options.queues == 1 ? "" : "s");
    text += formatted("compile    first %.0f us, fastest later %.0f us (median %.0f us)\n", result.cold_us,
                      result.warm_min_us, result.warm_median_us);
    for (const StageTime& time : result.stages)
        text += formatted("  %-16s %9.1f us  %5.1f %%\n", time.stage.c_str(), time.us,
                          100 * time.us / result.warm_min_us);
    for (const ScheduleCandidate& c : result.plan.schedule.candidates)
        text += formatted("order      %-9s peak of live bytes %.1f MiB, %u barrier batches%s\n",
                          c.name.c_str(), static_cast<double>(c.peak_live_bytes) / kMib, c.barrier_batches,
                          c.name == result.plan.schedule.chosen ? "  <- chosen" : "");
    text += formatted(
        "memory     all resources %.1f MiB, peak of live bytes %.1f MiB, heap %.1f MiB, heap / peak %.4f\n",
        static_cast<double>(memory.sum_bytes) / kMib, static_cast<double>(memory.peak_live_bytes) / kMib,
        static_cast<double>(memory.heap_bytes) / kMib,
        static_cast<double>(memory.heap_bytes) / static_cast<double>(memory.peak_live_bytes));
    return text + formatted("barriers   %u\n", result.plan.barriers.emitted);
}

}  // namespace

ExitCode run_bench_compile(const BenchOptions& options) {
    ResolvedGraph graph = make_bench_graph({options.passes, *bench_shape(options.shape), options.seed});
    // Every third pass gets the hint to run on the asynchronous compute queue. Otherwise, the plan would use
    // only one queue.
    for (size_t id = 0; options.queues > 1 && id < graph.passes.size(); id += 3)
        graph.passes[id].queue = QueueKind::compute;
    CompileOptions compile_options;
    compile_options.keep_all_passes = true;
    compile_options.granularity_bytes = 1;
    DeviceProfile profile;
    profile.queue_families = {{QueueKind::graphics, 1}, {QueueKind::compute, 2}, {QueueKind::transfer, 1}};
    compile_options.queues = logical_queues(profile, options.queues);
    const BenchResult result = measure(graph, compile_options);
    return print_data(options.json ? bench_json(options, result).dump(2) + "\n" : to_text(options, result));
}

}  // namespace weft::viewer
