// Purpose: measures the front end of the compiler (the stages from the text of a graph file to the resolved
// graph) and the checker of plans. Units: microseconds.
#pragma once

#include <vector>

#include "weft/compile.h"
#include "weft/plan.h"

namespace weft::viewer {

// Writes `graph`, a result of make_bench_graph(), as the text of a graph file. Then reads, merges, parses and
// resolves this text in two runs. Returns the times of these four stages in the faster run.
[[nodiscard]] std::vector<StageTime> measure_front_end(const ResolvedGraph& graph);

// Returns the time that the checker needs to prove `plan`: the shorter of two runs.
[[nodiscard]] double measure_check_us(const FramePlan& plan);

[[nodiscard]] double total_us(const std::vector<StageTime>& stages);

}  // namespace weft::viewer
