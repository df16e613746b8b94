// Purpose: divides buffers into pieces. Each range of elements that a port names begins and ends at a border
// between pieces, so each port uses whole pieces. Later stages treat the pieces as layers. Private to bind().
#pragma once

#include "graph/resolve/bind.h"

namespace weft {

// Finds the pieces of all buffers, and the range of each use of a buffer. All ages of a history have the same
// pieces. Errors: W125.
void divide_buffers(const Declared& declared, BoundPasses& bound, Reporter& reporter);

}  // namespace weft
