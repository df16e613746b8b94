// Purpose: texts about images with live sizes (sizes with a scale that can change in each frame).
#pragma once

#include <string>
#include <vector>

#include "weft/declaration.h"

namespace weft {

// Describes a value that depends on the live scales, which can change in each frame. For a parameter, returns
// its name. For a live size, returns a text such as "256x128 × renderScale". For a value without a name,
// returns the expression, such as "ceil(render / 2)".
[[nodiscard]] std::string describe_live(const ResolvedGraph& graph, uint32_t value);
// Returns the name of a value. If the value has no name, returns the text of describe_live().
[[nodiscard]] std::string live_name(const ResolvedGraph& graph, uint32_t value);
// Describes how the area of an image with a live size follows the scales, such as "render = 256x128 ×
// renderScale".
[[nodiscard]] std::string describe_area(const ResolvedGraph& graph, const ResourceDecl& image);

// Returns one text for each area. The text also lists the images that have this area, as in "render = 256x128
// × renderScale: color, depth".
[[nodiscard]] std::vector<std::string> list_areas(const ResolvedGraph& graph);

}  // namespace weft
