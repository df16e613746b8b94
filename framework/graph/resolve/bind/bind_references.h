// Purpose: finds the resource, the range, and the passes named with `@pass` for the references of all ports.
// Private to bind().
#pragma once

#include "graph/resolve/bind.h"

namespace weft {

// Fills in the uses, ports and absent ports of each pass, but not the accesses. Errors: W103 to W107, W110,
// W121 to W123.
[[nodiscard]] BoundPasses bind_references(const Declared& declared, Reporter& reporter);

}  // namespace weft
