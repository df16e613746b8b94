// Purpose: finds the pass that would write a resource if `if` did not leave it out. Messages of several
// stages name that pass.
#pragma once

#include <string>

#include "graph/resolve/expand.h"

namespace weft {

// Null: none.
[[nodiscard]] const PassDesc* dropped_writer(const Expansion& expansion, const std::string& resource,
                                             Reporter& reporter);

}  // namespace weft
