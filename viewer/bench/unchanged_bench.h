// Purpose: measures how long a session needs to see that the files of its graph have not changed. Units:
// microseconds.
#pragma once

#include "weft/load/load_graph.h"
#include "weft/plan.h"

namespace weft::viewer {

// Writes `graph`, a result of make_bench_graph(), and its shaders to files in a temporary folder, loads them
// with the loader that sessions use, and loads them again without a change. Returns the time of the fastest
// load without a change. `settings` has the reader of files and the folders; its limits are replaced.
[[nodiscard]] double measure_unchanged_us(const ResolvedGraph& graph, LoadSettings settings);

}  // namespace weft::viewer
