// Purpose: finds the pass that would write a resource if `if` had not removed the pass. Messages of several
// stages name this pass.
#pragma once

#include <string>

#include "graph/resolve/expand.h"

namespace weft {

// Null: none.
[[nodiscard]] const PassDesc* dropped_writer(const Expansion& expansion, const std::string& resource,
                                             Reporter& reporter);

}  // namespace weft
