// Purpose: history for graphs made by hand: "x", "x[-1]" … become the roles of one ring, as resolve() makes
// them.
#pragma once

#include <array>
#include <string>

#include "weft/declaration.h"

namespace weft::test {

// `history` 0 keeps one copy. The roles must all be there, of the same shape.
void make_ring(ResolvedGraph& graph, const std::string& name, uint32_t history,
               const std::array<float, 4>& first_frame);

}  // namespace weft::test
