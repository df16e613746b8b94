// Purpose: a resource of the graph that the program uses between frames (GraphRequest::exports).
#pragma once

#include "graph/resolve/reporter.h"
#include "weft/declaration.h"
#include "weft/graph_desc.h"
#include "weft/graph_request.h"

namespace weft {

// Gives the resource an object of its own, which the program uses between frames. Its states follow from its
// format: set_export_states(). Returns false after reporting the error W243: the resource lives longer than a
// frame.
[[nodiscard]] bool shape_export(const ResourceDesc& desc, const ExportUse& use, ResourceDecl& decl,
                                Reporter& reporter);

}  // namespace weft
