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
// Compiles all shaders that passes of the graph name. If passes of different types name the same shader, it
// is compiled once for each type. It can fit only one type; the other types get an error.
[[nodiscard]] ShaderCatalog compile_shaders(const GraphDesc& graph, const LoadInput& input,
                                            Diagnostics& faults);
// Resolves the graph. Of the alternative formats of an image, the first skipped[name] are not used.
[[nodiscard]] Result<ResolvedGraph> resolve_formats(const GraphDesc& desc, const ShaderCatalog& shaders,
                                                    const LoadInput& input, const SkippedFormats& skipped,
                                                    Diagnostics& warnings);

}  // namespace weft
