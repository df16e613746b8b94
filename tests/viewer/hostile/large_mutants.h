// Purpose: very large graphs up to 1 MiB (deep, wide, chained, misspelt), which are then damaged. The same
// seed gives the same graph.
#pragma once

#include <cstdint>
#include <string>

namespace weft::test {

struct LargeMutant {
    uint32_t seed = 0;
    std::string how;   // description, such as "wide ports, 421337 bytes, a byte changed"
    std::string text;  // text of the graph file
};
[[nodiscard]] LargeMutant make_large_mutant(uint32_t seed);

}  // namespace weft::test
