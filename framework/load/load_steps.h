// Purpose: the steps of loading one tier of a graph. load_graph() uses them for the tier of a request, and
// the choice of formats for all tiers.
#pragma once

#include <map>
#include <string>

#include "weft/load/load_graph.h"

namespace weft {

void append(Diagnostics& to, Diagnostics from);
// Merges the document for one tier and parses it.
[[nodiscard]] Result<GraphDesc> parse_tier(const JsonDoc& document, const std::string& tier,
                                           const GraphLimits& limits);
// Compiles all programs that the graph names. Passes of different types may name one shader: it is compiled
// for each type, and all types but one get an error.
[[nodiscard]] ShaderCatalog compile_shaders(const GraphDesc& graph, const LoadInput& input,
                                            Diagnostics& faults);
// Resolves the graph without the formats in `skipped`.
[[nodiscard]] Result<ResolvedGraph> resolve_formats(const GraphDesc& desc, const ShaderCatalog& shaders,
                                                    const LoadInput& input, const SkippedFormats& skipped,
                                                    Diagnostics& warnings);

}  // namespace weft
