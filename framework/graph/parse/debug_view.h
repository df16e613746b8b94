// Purpose: displays a resource with an additional pass and image, which are added to the graph before it is
// resolved, and observed. The graph's own output does not change. Errors: W103 neither a view nor a resource
// has that name, W109 the graph already uses one of the added names.
#pragma once

#include <string>
#include <vector>

#include "weft/graph_desc.h"
#include "weft/imports.h"

namespace weft {

// The image and the pass that a view adds.
inline constexpr const char* kDebugView = "debugView";

// The supported decodings of a resource: "color", "octahedral", "depth", …
[[nodiscard]] std::vector<std::string> debug_decoders();

// W103: views of resources that do not exist in the graph.
[[nodiscard]] Diagnostics debug_view_faults(const GraphDesc& graph);

// `name`: a view in the graph's "debug" section, or a reference to any resource.
[[nodiscard]] Status add_debug_view(GraphDesc& graph, const ImportCatalog& imports, const std::string& name);

}  // namespace weft
