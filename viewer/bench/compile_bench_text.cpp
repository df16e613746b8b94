#include <algorithm>
#include <nlohmann/json.hpp>

#include "viewer/bench/compile_bench.h"
#include "viewer/bench/front_end_bench.h"
#include "viewer/output/formatted.h"

namespace weft::viewer {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kMib = 1048576.0;

// The list of stages of a graph that a function prints: CompiledGraph::stages or CompiledGraph::front_end.
using StageList = std::vector<StageTime> CompiledGraph::*;

// Returns the statistics over all graphs for the time of one stage. `stage` is an index into the list. All
// graphs have the same stages.
OverSeeds stage_us(const std::vector<CompiledGraph>& graphs, StageList list, size_t stage) {
    return over_seeds(graphs, [=](const CompiledGraph& graph) { return (graph.*list)[stage].us; });
}

OverSeeds front_end_us(const std::vector<CompiledGraph>& graphs) {
    return over_seeds(graphs, [](const CompiledGraph& graph) { return total_us(graph.front_end); });
}

OverSeeds check_us(const std::vector<CompiledGraph>& graphs) {
    return over_seeds(graphs, [](const CompiledGraph& graph) { return graph.check_us; });
}

// Returns one line for each stage. `total` is the median of the total time, in microseconds.
std::string stages_text(const std::vector<CompiledGraph>& graphs, StageList list, double total) {
    std::string text;
    for (size_t stage = 0; stage < (graphs.front().*list).size(); ++stage) {
        const OverSeeds us = stage_us(graphs, list, stage);
        text += formatted("  %-16s %9.1f us  %5.1f %%   worst %9.1f us\n",
                          (graphs.front().*list)[stage].stage.c_str(), us.median, 100 * us.median / total,
                          us.worst);
    }
    return text;
}

Json stages_json(const std::vector<CompiledGraph>& graphs, StageList list) {
    Json stages = Json::object();
    for (size_t stage = 0; stage < (graphs.front().*list).size(); ++stage) {
        const OverSeeds us = stage_us(graphs, list, stage);
        stages[(graphs.front().*list)[stage].stage] = {{"median", us.median}, {"worst", us.worst}};
    }
    return stages;
}

Json us_json(const OverSeeds& us) {
    return {{"median", us.median}, {"worst", us.worst}, {"worst_seed", us.worst_seed}};
}

OverSeeds compile_us(const std::vector<CompiledGraph>& graphs) {
    return over_seeds(graphs, [](const CompiledGraph& graph) { return graph.min_us; });
}

std::string graph_text(const CompiledGraph& graph) {
    std::string text;
    for (const ScheduleCandidate& c : graph.candidates)
        text += formatted("order      %-9s peak of live bytes %.1f MiB, %u barrier batches%s\n",
                          c.name.c_str(), static_cast<double>(c.peak_live_bytes) / kMib, c.barrier_batches,
                          c.name == graph.chosen ? "  <- chosen" : "");
    const MemoryPlan& memory = graph.memory;
    text += formatted("memory     all resources %.1f MiB, peak of live bytes %.1f MiB, heap %.1f MiB\n",
                      static_cast<double>(memory.sum_bytes) / kMib,
                      static_cast<double>(memory.peak_live_bytes) / kMib,
                      static_cast<double>(memory.heap_bytes) / kMib);
    return text + formatted("barriers   %u\n", graph.barriers);
}

// Returns how many graphs chose each candidate order.
std::string orders_text(const std::vector<CompiledGraph>& graphs) {
    std::string text = "order     ";
    for (const ScheduleCandidate& c : graphs.front().candidates)
        text += formatted(" %s %zu times", c.name.c_str(),
                          static_cast<size_t>(std::ranges::count(graphs, c.name, &CompiledGraph::chosen)));
    return text + "\n";
}

Json graph_json(const CompiledGraph& graph) {
    Json candidates = Json::array();
    for (const ScheduleCandidate& c : graph.candidates)
        candidates.push_back({{"name", c.name},
                              {"peak_live_bytes", c.peak_live_bytes},
                              {"batches", c.barrier_batches},
                              {"queue_switches", c.queue_switches}});
    Json stages = Json::object(), front_end = Json::object();
    for (const StageTime& time : graph.stages) stages[time.stage] = time.us;
    for (const StageTime& time : graph.front_end) front_end[time.stage] = time.us;
    return {{"seed", graph.seed},
            {"cold_us", graph.first_us},
            {"warm_us", {{"min", graph.min_us}, {"median", graph.median_us}}},
            {"stages_us", stages},
            {"front_end_us", front_end},
            {"check_us", graph.check_us},
            {"peak_live_bytes", graph.memory.peak_live_bytes},
            {"heap_bytes", graph.memory.heap_bytes},
            {"candidates", candidates},
            {"chosen", graph.chosen},
            {"barriers", graph.barriers}};
}

}  // namespace

std::string compile_bench_text(const BenchOptions& options, const std::vector<CompiledGraph>& graphs) {
    const OverSeeds total = compile_us(graphs);
    std::string text = formatted("%u passes, %s, %u queue%s, ", options.passes, options.shape.c_str(),
                                 options.queues, options.queues == 1 ? "" : "s");
    if (graphs.size() == 1)
        text += formatted("seed %u\n", options.seed);
    else
        text +=
            formatted("%zu graphs: seeds %u to %u\n", graphs.size(), graphs.front().seed, graphs.back().seed);
    text += formatted("compile    median %.0f us, worst %.0f us (seed %u), first in this process %.0f us\n",
                      total.median, total.worst, total.worst_seed, graphs.front().first_us);
    text += stages_text(graphs, &CompiledGraph::stages, total.median);
    const OverSeeds front_end = front_end_us(graphs), check = check_us(graphs);
    text += formatted(
        "front end  median %.0f us, worst %.0f us (seed %u): from the text of a file to the graph\n",
        front_end.median, front_end.worst, front_end.worst_seed);
    text += stages_text(graphs, &CompiledGraph::front_end, front_end.median);
    text += formatted("check      median %.0f us, worst %.0f us (seed %u): proof of the plan\n", check.median,
                      check.worst, check.worst_seed);
    text += formatted("unchanged  %.1f us to find that no file of the first graph has changed\n",
                      graphs.front().reload.unchanged_us);
    text += formatted("value      %.1f us to give the first graph another value of a parameter\n",
                      graphs.front().reload.value_us);
    const OverSeeds heap = over_seeds(graphs, &CompiledGraph::heap_to_peak);
    text += formatted("heap / peak of live bytes: mean %.4f, worst %.4f (seed %u)\n", heap.mean, heap.worst,
                      heap.worst_seed);
    return text + (graphs.size() == 1 ? graph_text(graphs.front()) : orders_text(graphs));
}

std::string compile_bench_json(const BenchOptions& options, const std::vector<CompiledGraph>& graphs) {
    const OverSeeds total = compile_us(graphs), heap = over_seeds(graphs, &CompiledGraph::heap_to_peak);
    Json all = Json::array();
    for (const CompiledGraph& graph : graphs) all.push_back(graph_json(graph));
    const Json json{
        {"passes", options.passes},
        {"shape", options.shape},
        {"queues", options.queues},
        {"us", us_json(total)},
        {"stages_us", stages_json(graphs, &CompiledGraph::stages)},
        {"front_end_us", us_json(front_end_us(graphs))},
        {"front_end_stages_us", stages_json(graphs, &CompiledGraph::front_end)},
        {"check_us", us_json(check_us(graphs))},
        {"unchanged_us", graphs.front().reload.unchanged_us},
        {"value_us", graphs.front().reload.value_us},
        {"heap_to_peak", {{"mean", heap.mean}, {"worst", heap.worst}, {"worst_seed", heap.worst_seed}}},
        {"graphs", all}};
    return json.dump(2) + "\n";
}

}  // namespace weft::viewer
