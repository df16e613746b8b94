#include "viewer/bench/compile_bench.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "graph/compile/bench_graph.h"
#include "viewer/bench/front_end_bench.h"
#include "viewer/bench/reload_bench.h"

namespace weft::viewer {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kLaterRuns = 5;

ResolvedGraph make_graph(const BenchOptions& options, uint32_t seed) {
    ResolvedGraph graph = make_bench_graph({options.passes, *bench_shape(options.shape), seed});
    // Every third pass gets the hint to run on the asynchronous compute queue. Otherwise, the plan would use
    // only one queue.
    for (size_t id = 0; options.queues > 1 && id < graph.passes.size(); id += 3)
        graph.passes[id].queue = QueueKind::compute;
    return graph;
}

CompileOptions options_of(const BenchOptions& options) {
    DeviceProfile profile;
    profile.queue_families = {{QueueKind::graphics, 1}, {QueueKind::compute, 2}, {QueueKind::transfer, 1}};
    return {
        .keep_all_passes = true, .granularity_bytes = 1, .queues = logical_queues(profile, options.queues)};
}

CompiledGraph measure_graph(const BenchOptions& options, uint32_t seed) {
    const ResolvedGraph graph = make_graph(options, seed);
    const MemoryNeeds needs = bench_needs(graph);
    const CompileOptions compile_options = options_of(options);
    CompiledGraph result;
    result.seed = seed;
    std::vector<StageTime> stages;
    FramePlan plan;
    // compile() takes ownership of the graph, so each run needs its own copy. The measured time excludes the
    // copy, and the destruction of the previous plan.
    const auto timed = [&] {
        ResolvedGraph own = graph;
        const Clock::time_point start = Clock::now();
        FramePlan next = compile(std::move(own), needs, compile_options, &stages);
        const double us = std::chrono::duration<double, std::micro>(Clock::now() - start).count();
        plan = std::move(next);
        return us;
    };
    result.first_us = timed();
    std::vector<double> later;
    for (int run = 0; run < kLaterRuns; ++run) {
        later.push_back(timed());
        if (later.back() == *std::ranges::min_element(later)) result.stages = stages;
    }
    std::ranges::sort(later);
    result.min_us = later.front();
    result.median_us = later[later.size() / 2];
    result.front_end = measure_front_end(graph);
    result.check_us = measure_check_us(plan);
    result.memory = std::move(plan.memory);
    result.memory.placements.clear();
    result.memory.alias_transitions.clear();
    result.candidates = plan.schedule.candidates;
    result.chosen = plan.schedule.chosen;
    result.barriers = plan.barriers.emitted;
    return result;
}

}  // namespace

double CompiledGraph::heap_to_peak() const {
    return static_cast<double>(memory.heap_bytes) / static_cast<double>(memory.peak_live_bytes);
}

std::vector<CompiledGraph> measure_compile(const BenchOptions& options, const LoadSettings& settings,
                                           const std::function<void(uint32_t)>& progress) {
    std::vector<CompiledGraph> graphs;
    for (uint32_t i = 0; i < options.seeds; ++i) {
        graphs.push_back(measure_graph(options, options.seed + i));
        if (i == 0) graphs[0].reload = measure_reload(make_graph(options, options.seed), settings);
        progress(i + 1);
    }
    return graphs;
}

OverSeeds over_seeds(const std::vector<CompiledGraph>& graphs,
                     const std::function<double(const CompiledGraph&)>& value) {
    std::vector<std::pair<double, uint32_t>> values;
    OverSeeds all;
    for (const CompiledGraph& graph : graphs) {
        values.emplace_back(value(graph), graph.seed);
        all.mean += values.back().first / static_cast<double>(graphs.size());
    }
    std::ranges::sort(values);
    all.median = values[values.size() / 2].first;
    all.worst = values.back().first;
    all.worst_seed = values.back().second;
    return all;
}

}  // namespace weft::viewer
