// Purpose: texts about images with live sizes.
#pragma once

#include <string>
#include <vector>

#include "weft/declaration.h"

namespace weft {

// Returns how a value follows the scales, such as "256x128 × renderScale" for a live size, or the expression
// of a value without a name, such as "ceil(render / 2)".
[[nodiscard]] std::string describe_live(const ResolvedGraph& graph, uint32_t value);
// Returns the name of a value; if it has no name, the same as describe_live().
[[nodiscard]] std::string live_name(const ResolvedGraph& graph, uint32_t value);
// Returns how the area of a live image follows the scales, such as "render = 256x128 × renderScale".
[[nodiscard]] std::string describe_area(const ResolvedGraph& graph, const ResourceDecl& image);

// Returns one text for each area, with the images that have it, such as "render = 256x128 × renderScale:
// color, depth".
[[nodiscard]] std::vector<std::string> list_areas(const ResolvedGraph& graph);

}  // namespace weft
