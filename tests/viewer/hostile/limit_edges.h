// Purpose: the worst input at the edge of each limit on graph files: a text with exactly as many things as
// the limit allows.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>

#include "tests/viewer/program.h"

namespace weft::test {

struct LimitEdge {
    const char* limit;    // "graph.passes"
    uint64_t small = 0;   // a lower value, for quick runs
    bool is_good = true;  // at the edge the graph is accepted; false: it is refused for another reason
    // Writes graph.json and the files that it includes.
    void (*write)(const ScratchFolder& folder, uint64_t count) = nullptr;
};
[[nodiscard]] std::span<const LimitEdge> limit_edges();

}  // namespace weft::test
