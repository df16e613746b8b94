// Purpose: large graphs for which nobody made the reader: deep, wide, chained, misspelt, up to 1 MiB, and
// then damaged. The same seed gives the same graph.
#pragma once

#include <cstdint>
#include <string>

namespace weft::test {

struct LargeMutant {
    uint32_t seed = 0;
    std::string how;   // "wide ports, 421337 bytes, a byte changed"
    std::string text;  // of the graph's file
};
[[nodiscard]] LargeMutant make_large_mutant(uint32_t seed);

}  // namespace weft::test
