// Purpose: the steps that load one tier of a graph. load_graph() uses them, and so does the choice of
// formats, which loads all tiers.
#pragma once

#include <map>
#include <string>

#include "weft/load/load_graph.h"

namespace weft {

void append(Diagnostics& to, Diagnostics from);
// The merged and parsed graph of this tier, with the debug view added.
[[nodiscard]] Result<GraphDesc> described(const JsonDoc& document, const LoadInput& input);
// All programs that the graph names. A shader that passes of several types name is compiled once per type;
// only one type can be right, so the others get a message.
[[nodiscard]] ShaderCatalog compile_shaders(const GraphDesc& graph, const LoadInput& input,
                                            Diagnostics& faults);
[[nodiscard]] Result<ResolvedGraph> resolved(const GraphDesc& desc, const ShaderCatalog& shaders,
                                             const LoadInput& input, const SkippedFormats& skipped,
                                             Diagnostics& warnings);

}  // namespace weft
