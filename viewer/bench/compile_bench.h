// Purpose: measures the graph compiler for `weft bench compile`. It compiles several generated graphs, which
// differ in their seeds, reads them from the text of a file, and checks their plans. It collects times and
// properties of the plans. Units: microseconds and bytes.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "viewer/bench/reload_bench.h"
#include "viewer/options/options.h"
#include "weft/compile.h"
#include "weft/load/load_graph.h"

namespace weft::viewer {

// The results for one graph. It is compiled several times.
struct CompiledGraph {
    uint32_t seed = 0;
    double first_us = 0;               // Time of the first compilation.
    double min_us = 0;                 // Time of the fastest later compilation.
    double median_us = 0;              // Median time of all later compilations.
    std::vector<StageTime> stages;     // Times of the compiler's stages in the fastest later compilation.
    std::vector<StageTime> front_end;  // Times of the stages from the graph file to the resolved graph.
    double check_us = 0;               // Time that the checker needs for the plan.
    ReloadTimes reload;                // Measured only for the first graph, else 0.
    MemoryPlan memory;                 // The memory plan without its placements and alias transitions.
    // The candidate orders of the passes, from which the compiler chose one.
    std::vector<ScheduleCandidate> candidates;
    std::string chosen;  // Name of the chosen candidate.
    uint32_t barriers = 0;

    // Returns the size of the heap, divided by the peak of the bytes that are in use at the same time.
    [[nodiscard]] double heap_to_peak() const;
};

// Compiles one graph for each seed, and returns the measurements of all graphs. To measure reloads, the first
// graph is also written to files and loaded from them with `settings`. After each graph, calls `progress`
// with the number of graphs compiled so far.
[[nodiscard]] std::vector<CompiledGraph> measure_compile(const BenchOptions& options,
                                                         const LoadSettings& settings,
                                                         const std::function<void(uint32_t)>& progress);

// Statistics of one value over all graphs. `worst` is the largest value. `worst_seed` is the seed of the
// graph that has this value.
struct OverSeeds {
    double mean = 0, median = 0, worst = 0;
    uint32_t worst_seed = 0;
};
[[nodiscard]] OverSeeds over_seeds(const std::vector<CompiledGraph>& graphs,
                                   const std::function<double(const CompiledGraph&)>& value);

[[nodiscard]] std::string compile_bench_text(const BenchOptions& options,
                                             const std::vector<CompiledGraph>& graphs);
[[nodiscard]] std::string compile_bench_json(const BenchOptions& options,
                                             const std::vector<CompiledGraph>& graphs);

}  // namespace weft::viewer
