// Purpose: measures how long a session needs to load a graph again if its files have not changed. Units:
// microseconds.
#pragma once

#include "weft/load/load_graph.h"
#include "weft/plan.h"

namespace weft::viewer {

// The time of the fastest load in each of two cases.
struct ReloadTimes {
    double unchanged_us = 0;  // The request is the same as in the previous load.
    // The request has another value of one parameter than in the previous load. Only shaders use this
    // parameter, in the block `Params`.
    double value_us = 0;
};

// Writes `graph`, a result of make_bench_graph(), and its shaders to files in a temporary folder, loads them
// with the loader that sessions use, and loads them again. `settings` gives the reader of files and the
// folders of Weft. This function uses other limits than those in `settings`.
[[nodiscard]] ReloadTimes measure_reload(const ResolvedGraph& graph, LoadSettings settings);

}  // namespace weft::viewer
