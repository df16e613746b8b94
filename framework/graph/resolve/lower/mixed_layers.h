// Purpose: finds passes that draw several views although their layers begin with different contents. One load
// operation applies to all layers of an attachment, so such a pass must be divided into one pass for each
// view.
#pragma once

#include "graph/resolve/version.h"

namespace weft {

// Returns the passes to divide, with the reason. Errors: W199, if the author asked for one pass.
[[nodiscard]] SeparateViews find_mixed_layers(const Declared& declared, const VersionedGraph& graph,
                                              Reporter& reporter);

}  // namespace weft
