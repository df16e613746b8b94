// Purpose: displays any resource of a graph for debugging. A pass and an image are added to the graph before
// the graph is resolved. The pass draws the resource into the image, which the program can read back or show.
// The output image of the graph does not change. Errors:
// W103: no debug view and no resource has the given name, or a debug view shows an unknown resource.
// W109: the graph already uses the name "debugView".
// W109: the resource is a 3D or multisampled image and the debug view has no shader of its own.
#pragma once

#include <string>
#include <vector>

#include "weft/graph_desc.h"
#include "weft/imports.h"

namespace weft {

// The name of both the image and the pass that are added to the graph to display a resource.
inline constexpr const char* kDebugView = "debugView";

// Returns the names of all ways to decode a resource for display: "color", "octahedral", "depth" and others.
[[nodiscard]] std::vector<std::string> debug_decoders();

// Returns an error W103 for each debug view whose resource does not exist in the graph.
[[nodiscard]] Diagnostics debug_view_faults(const GraphDesc& graph);

// Adds the pass and the image that display a resource to `graph`. `name` is the name of a view in the graph's
// "debug" section, or a reference to any resource.
[[nodiscard]] Status add_debug_view(GraphDesc& graph, const ImportCatalog& imports, const std::string& name);

}  // namespace weft
