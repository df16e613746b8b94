// Purpose: the steps of loading one tier of a graph, for load_graph() and for the choice of formats, which
// looks at all tiers.
#pragma once

#include <map>
#include <string>

#include "weft/load/load_graph.h"

namespace weft {

// What the author asks for in this tier: merged, parsed, and the debug view added.
[[nodiscard]] Result<GraphDesc> described(const JsonDoc& document, const LoadInput& input);
// All programs that the graph names. A shader that passes of several types name is compiled for each: all but
// one of them get a message.
[[nodiscard]] ShaderCatalog compile_shaders(const GraphDesc& graph, const LoadInput& input,
                                            Diagnostics& faults);
[[nodiscard]] Result<ResolvedGraph> resolved(const GraphDesc& desc, const ShaderCatalog& shaders,
                                             const LoadInput& input, const SkippedFormats& skipped,
                                             Diagnostics& warnings);

}  // namespace weft
