// Purpose: finds what a name means inside of a module after parsing. Shaders of a module name its parameters
// and constants without the name of the module.
#pragma once

#include <string>
#include <string_view>

#include "weft/graph_desc.h"

namespace weft {

// Returns the name of the module of a part: "glass" for "glass::cull"; empty for a part of the graph.
[[nodiscard]] std::string_view module_of(const GraphDesc& graph, std::string_view part);

// Returns the full name of the parameter, constant or size that `name` means inside of a module. An empty
// module is the graph itself. Names that only the program provides do not change.
[[nodiscard]] std::string name_in_module(const GraphDesc& graph, std::string_view module,
                                         const std::string& name);

// Returns the name of the size that an image without "size" has, in the module to which the resource
// belongs.
[[nodiscard]] std::string render_size_name(const GraphDesc& graph, std::string_view resource);

}  // namespace weft
