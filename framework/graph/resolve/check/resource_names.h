// Purpose: collects the names of the resources that ports, debug views and tests mention.
#pragma once

#include <set>
#include <string>

#include "weft/graph_desc.h"

namespace weft {

using ResourceNames = std::set<std::string, std::less<>>;

// Adds the names of the resources that a port may use, including the resource of its "else".
void add_names(const PortDesc& port, ResourceNames& names);
void add_inputs(const PassDesc& desc, ResourceNames& names);
// Returns the names of the resources that debug views and tests use.
[[nodiscard]] ResourceNames watched_resources(const GraphDesc& graph);

}  // namespace weft
