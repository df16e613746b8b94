// Purpose: parses JSON into a GraphDesc, the description written by the author.
#pragma once

#include "weft/graph_desc.h"
#include "weft/limits.h"
#include "weft/result.h"
#include "weft/syntax/json_doc.h"

namespace weft {

[[nodiscard]] Result<GraphDesc> parse(const JsonDoc& document, const GraphLimits& limits = {});

}  // namespace weft
