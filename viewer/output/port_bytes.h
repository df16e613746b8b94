// Purpose: what a pass moves at least, by what it declares. Units: bytes.
#pragma once

#include <cstdint>

#include "weft/declaration.h"

namespace weft::viewer {

// What a pass's ports touch: the bytes of every range, read and written once each.
[[nodiscard]] uint64_t port_bytes(const ResolvedGraph& graph, const PassDecl& pass);

}  // namespace weft::viewer
