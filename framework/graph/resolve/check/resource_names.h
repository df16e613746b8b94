// Purpose: collects the names of the resources that ports, debug views and tests mention.
#pragma once

#include <string_view>
#include <unordered_set>

#include "weft/graph_desc.h"

namespace weft {

// The names point into strings of the GraphDesc from which they were collected.
using ResourceNames = std::unordered_set<std::string_view>;

// Adds the names of the resources that a port may use, including the resource of its "else".
void add_names(const PortDesc& port, ResourceNames& names);
void add_inputs(const PassDesc& desc, ResourceNames& names);
// Returns the names of the resources that debug views and tests use.
[[nodiscard]] ResourceNames watched_resources(const GraphDesc& graph);

}  // namespace weft
