// Purpose: converts the references of all ports to resources, ranges and pins. Private to bind().
#pragma once

#include "graph/resolve/bind.h"

namespace weft {

// Fills in uses, ports and absent ports of every pass, without accesses. Errors: W103 to W107, W110, W121 to
// W123.
[[nodiscard]] BoundPasses bind_references(const Declared& declared, Reporter& reporter);

}  // namespace weft
