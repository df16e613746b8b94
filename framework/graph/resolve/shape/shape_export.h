// Purpose: a resource of the graph that the program uses between frames (GraphRequest::exports).
#pragma once

#include "graph/resolve/reporter.h"
#include "weft/declaration.h"
#include "weft/graph_desc.h"
#include "weft/graph_request.h"

namespace weft {

// Gives the resource the usage that the program needs. A resource that lives within one frame also gets an
// object of its own. Its states depend on its format, so set_export_states() sets them later. Returns false
// after reporting the error W243: nothing in the graph writes the resource, or the program would write a kept
// resource.
[[nodiscard]] bool shape_export(const ResourceDesc& desc, const ExportUse& use, ResourceDecl& decl,
                                Reporter& reporter);

// Sets the states of all exports between frames. The formats of the exports must be known.
void set_export_states(const GraphRequest& request, std::vector<ResourceDecl>& resources);

}  // namespace weft
