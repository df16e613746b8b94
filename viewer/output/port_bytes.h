// Purpose: computes the least memory traffic of a pass from the declarations of its ports, in bytes.
#pragma once

#include <cstdint>

#include "weft/declaration.h"

namespace weft::viewer {

// Returns the sum over all ports of the pass. A port that only reads, or only writes, adds the size of its
// mips and layers, or of its whole buffer, once. A port that reads and writes adds this size twice.
[[nodiscard]] uint64_t port_bytes(const ResolvedGraph& graph, const PassDecl& pass);

}  // namespace weft::viewer
