// Purpose: finds a pass that would write a resource, but that is removed because its `if` is false or its
// repeat is empty. Several stages name this pass in their messages.
#pragma once

#include <string>

#include "graph/resolve/expand.h"

namespace weft {

// Returns the description of the removed pass that writes the resource, or null if there is none.
[[nodiscard]] const PassDesc* dropped_writer(const Expansion& expansion, const std::string& resource,
                                             Reporter& reporter);

}  // namespace weft
