// Purpose: the minimum memory traffic of a pass according to its declaration. Units: bytes.
#pragma once

#include <cstdint>

#include "weft/declaration.h"

namespace weft::viewer {

// The bytes of all ranges of the pass's ports, each read and written once.
[[nodiscard]] uint64_t port_bytes(const ResolvedGraph& graph, const PassDecl& pass);

}  // namespace weft::viewer
