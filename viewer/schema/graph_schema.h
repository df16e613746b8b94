// Purpose: the schema of one graph: that of all graphs, in which its own names are the ones to choose from.
#pragma once

#include <string>

#include "viewer/schema/schema_names.h"

namespace weft::viewer {

[[nodiscard]] std::string graph_schema(const GraphNames& names);

}  // namespace weft::viewer
