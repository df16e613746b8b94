// Purpose: the names of resources that ports, views and tests mention.
#pragma once

#include <functional>
#include <set>
#include <string>

#include "weft/graph_desc.h"

namespace weft {

using ResourceNames = std::set<std::string, std::less<>>;

void add_names(const PortDesc& port, ResourceNames& names);  // its "else" too
void add_inputs(const PassDesc& desc, ResourceNames& names);
// The resources used by debug views and tests.
[[nodiscard]] ResourceNames watched_resources(const GraphDesc& graph);

}  // namespace weft
