// Purpose: marks resources and passes about which something is unknown because of an error that was already
// reported. Later stages do not report consequences of that error.
#pragma once

#include <cstdint>
#include <vector>

namespace weft {

// Marks the resources and passes that are suspect: an error was reported, so some of their properties are
// unknown, and no further errors are reported about these properties. Elements are 1 (suspect) or 0.
struct Suspects {
    // Indexed by ResourceId: extent, mips or format of the resource are unknown.
    std::vector<uint8_t> shapes;
    // Indexed by ResourceId: it is unknown which passes write the resource, because a pass with an error may
    // write it.
    std::vector<uint8_t> writers;
    // Indexed by PassId: the pass has an error, and some of its uses may be missing.
    std::vector<uint8_t> passes;
    // Indexed by PassId, then by use: an error about the reference of this use was reported.
    std::vector<std::vector<uint8_t>> uses;
};

}  // namespace weft
