// Purpose: parses the JSON of a graph file into a GraphDesc, which describes the graph as its author wrote
// it.
#pragma once

#include "weft/graph_desc.h"
#include "weft/limits.h"
#include "weft/result.h"
#include "weft/syntax/json_doc.h"

namespace weft {

[[nodiscard]] Result<GraphDesc> parse(const JsonDoc& document, const GraphLimits& limits = {});

}  // namespace weft
