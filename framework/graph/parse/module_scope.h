// Purpose: after parsing, finds the part of the graph that a name means inside a module. In the shaders of a
// module, the names of the module's own parameters and constants do not begin with the name of the module.
#pragma once

#include <string>
#include <string_view>

#include "weft/graph_desc.h"

namespace weft {

// Returns the name of the module to which a part of the graph (for example a pass) belongs: "glass" for
// "glass::cull". Returns an empty text if the part belongs to no module.
[[nodiscard]] std::string_view module_of(const GraphDesc& graph, std::string_view part);

// Returns the full name of the parameter, constant or size that `name` means inside a module. If `module` is
// empty, it stands for the graph itself. Names of values that only the program provides are returned
// unchanged.
[[nodiscard]] std::string name_in_module(const GraphDesc& graph, std::string_view module,
                                         const std::string& name);

// Returns the full name of the size "render" in the module to which the resource belongs. An image without
// the key "size" has this size.
[[nodiscard]] std::string render_size_name(const GraphDesc& graph, std::string_view resource);

}  // namespace weft
