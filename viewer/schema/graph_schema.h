// Purpose: the schema of one graph: the schema of all graphs, with this graph's own names as choices.
#pragma once

#include <string>

#include "viewer/schema/schema_names.h"

namespace weft::viewer {

[[nodiscard]] std::string graph_schema(const GraphNames& names);

}  // namespace weft::viewer
