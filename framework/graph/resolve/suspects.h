// Purpose: facts that are unknown because of a reported fault. A stage does not report consequences of them.
#pragma once

#include <cstdint>
#include <vector>

namespace weft {

// 1 where something is suspect.
struct Suspects {
    std::vector<uint8_t> shapes;   // by ResourceId: extent, mips or format are unknown
    std::vector<uint8_t> writers;  // by ResourceId: a faulty pass may write it
    std::vector<uint8_t> passes;   // by PassId: the pass is faulty, and some of its uses may be missing
    std::vector<std::vector<uint8_t>> uses;  // by PassId and use: its reference is reported
};

}  // namespace weft
