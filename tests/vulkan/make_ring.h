// Purpose: adds a history to a graph that a test made by hand. The resources "x", "x[-1]" and so on become
// the copies of one ring, as resolve() does it.
#pragma once

#include <array>
#include <string>

#include "weft/declaration.h"

namespace weft::test {

// Makes a ring of `history` + 1 copies. With `history` 0, the one copy is kept from frame to frame. All
// resources of the ring must exist and have the same format and size.
void make_ring(ResolvedGraph& graph, const std::string& name, uint32_t history,
               const std::array<float, 4>& first_frame);

}  // namespace weft::test
