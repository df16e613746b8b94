// Purpose: which pass that `if` leaves out would write a resource. Messages of several stages name it.
#pragma once

#include <string>

#include "graph/resolve/expand.h"

namespace weft {

// Null: none.
[[nodiscard]] const PassDesc* dropped_writer(const Expansion& expansion, const std::string& resource,
                                             Reporter& reporter);

}  // namespace weft
