// Purpose: adds a history to a graph that a test made by hand. The resources "x", "x[-1]" and so on become
// the copies of one ring. For the graph of a file, resolve() does the same.
#pragma once

#include <array>
#include <string>

#include "weft/declaration.h"

namespace weft::test {

// Makes a ring of `history` + 1 copies. With `history` 0, the one copy is kept from frame to frame. All
// resources of the ring must exist and have the same format and size. `first_frame` is the initial value of
// every copy, before the first write.
void make_ring(ResolvedGraph& graph, const std::string& name, uint32_t history,
               const std::array<float, 4>& first_frame);

}  // namespace weft::test
