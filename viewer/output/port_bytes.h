// Purpose: computes the least memory traffic of a pass from the declarations of its ports, in bytes.
#pragma once

#include <cstdint>

#include "weft/declaration.h"

namespace weft::viewer {

// Returns the sum over all ports of the pass: the size of the used range for reading, and the same again for
// writing.
[[nodiscard]] uint64_t port_bytes(const ResolvedGraph& graph, const PassDecl& pass);

}  // namespace weft::viewer
