// Purpose: adds history to hand-made graphs: "x", "x[-1]" … become one ring, as in resolve().
#pragma once

#include <array>
#include <string>

#include "weft/declaration.h"

namespace weft::test {

// `history` 0 keeps one copy. All resources of the ring must exist and have the same shape.
void make_ring(ResolvedGraph& graph, const std::string& name, uint32_t history,
               const std::array<float, 4>& first_frame);

}  // namespace weft::test
