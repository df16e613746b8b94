// Purpose: makes random graphs of up to 1 MiB (deep, wide, chained or misspelt) and damages most of them. The
// same seed always gives the same graph.
#pragma once

#include <cstdint>
#include <string>

namespace weft::test {

struct LargeMutant {
    uint32_t seed = 0;
    // Description of the graph, such as "wide ports, 421337 bytes, a byte changed".
    std::string how;
    // Text of the graph file.
    std::string text;
};
[[nodiscard]] LargeMutant make_large_mutant(uint32_t seed);

}  // namespace weft::test
