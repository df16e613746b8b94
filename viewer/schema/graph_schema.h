// Purpose: makes the JSON schema for one graph. This is the schema of all graphs, with the names in this
// graph as choices for completion in editors.
#pragma once

#include <string>

#include "viewer/schema/schema_names.h"

namespace weft::viewer {

[[nodiscard]] std::string graph_schema(const GraphNames& names);

}  // namespace weft::viewer
