// Purpose: the steps that load one tier of a graph. load_graph() uses them for the tier of its request. The
// choice of formats uses them for all tiers.
#pragma once

#include <map>
#include <string>

#include "weft/load/load_graph.h"

namespace weft {

void append(Diagnostics& to, Diagnostics from);
// Merges the document for one tier and parses the result.
[[nodiscard]] Result<GraphDesc> parse_tier(const JsonDoc& document, const std::string& tier,
                                           const GraphLimits& limits);
// Compiles all shaders that passes of the graph name. If passes of different types name the same shader, the
// shader is compiled once for each type. A shader fits only one type, so that the compilation for every other
// type gives an error.
[[nodiscard]] ShaderCatalog compile_shaders(const GraphDesc& graph, const LoadInput& input,
                                            Diagnostics& faults);
// Resolves the graph. `skipped` gives for each image how many of its alternative formats are not used,
// counted from the first.
[[nodiscard]] Result<ResolvedGraph> resolve_formats(const GraphDesc& desc, const ShaderCatalog& shaders,
                                                    const LoadInput& input, const SkippedFormats& skipped,
                                                    Diagnostics& warnings);

}  // namespace weft
