// Purpose: finds out whether a pass uses the index of its repeat.
#pragma once

#include <string>

#include "weft/graph_desc.h"

namespace weft {

// Returns the first place in a pass description whose expression names `index`, for a message: "the key
// \"if\"". Empty if there is none. Does not examine the layer of an output that selects a single layer.
[[nodiscard]] std::string place_of_index(const PassDesc& desc, const std::string& index);

}  // namespace weft
