// Purpose: a way to look at a resource, made of a pass and an image like any other: they are added to the
// graph before it is resolved, and observed. The graph's own output stays as it is. Errors: W103 neither a
// view nor a resource of that name, W109 names that the graph has taken.
#pragma once

#include <string>
#include <vector>

#include "weft/graph_desc.h"
#include "weft/imports.h"

namespace weft {

// The image and the pass that a view adds.
inline constexpr const char* kDebugView = "debugView";

// What a resource can be shown as: "color", "octahedral", "depth", …
[[nodiscard]] std::vector<std::string> debug_decoders();

// W103: views of resources that the graph doesn't have.
[[nodiscard]] Diagnostics debug_view_faults(const GraphDesc& graph);

// `name`: a view of the graph's "debug", or a reference to any resource.
[[nodiscard]] Status add_debug_view(GraphDesc& graph, const ImportCatalog& imports, const std::string& name);

}  // namespace weft
