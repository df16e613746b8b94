// Purpose: makes an expensive input for the test of each limit on graph files: a graph with a given number of
// the things that the limit counts.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>

#include "tests/viewer/program.h"

namespace weft::test {

struct LimitEdge {
    // Name of the limit, such as "graph.passes".
    const char* limit;
    // A lower value of the limit, which the quick tests set with --limits. It is 0 if another test covers the
    // limit.
    uint64_t small = 0;
    // True if `weft` accepts the graph at the limit. False if it refuses the graph for a reason other than
    // the limit.
    bool is_good = true;
    // Writes a graph.json that needs `count` of the things that the limit counts, for example passes. Also
    // writes the files that the graph includes.
    void (*write)(const ScratchFolder& folder, uint64_t count) = nullptr;
};
[[nodiscard]] std::span<const LimitEdge> limit_edges();

}  // namespace weft::test
