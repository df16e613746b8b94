// Purpose: finds, for each reference of a port, the resource, the range, and the pass that `@pass` names.
// Private to bind().
#pragma once

#include "graph/resolve/bind.h"

namespace weft {

// Fills in the uses, ports, absent ports and the view of each pass, but not the accesses. Errors: W103 to
// W107, W109, W110, W118, W121 to W123, W125, W230.
[[nodiscard]] BoundPasses bind_references(const Declared& declared, Reporter& reporter);

}  // namespace weft
