// Purpose: for each limit of a graph's file, the worst input at its edge: text that holds exactly so much of
// what the limit counts.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>

#include "tests/viewer/program.h"

namespace weft::test {

struct LimitEdge {
    const char* limit;    // "graph.passes"
    uint64_t small = 0;   // a value for runs that must not cost much
    bool is_good = true;  // at the edge the graph is accepted; otherwise it is refused for another reason
    // Writes graph.json, and what it includes.
    void (*write)(const ScratchFolder& folder, uint64_t count) = nullptr;
};
[[nodiscard]] std::span<const LimitEdge> limit_edges();

}  // namespace weft::test
