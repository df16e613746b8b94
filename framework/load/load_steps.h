// Purpose: the steps that load one tier of a graph. load_graph() uses them for the tier of its request.
// tier_formats.h uses them for all tiers, to choose formats that suit every tier.
#pragma once

#include <map>
#include <string>

#include "graph/resolve/resolve.h"
#include "weft/load/load_graph.h"

namespace weft {

void append(Diagnostics& to, Diagnostics from);
// Merges the document for one tier, parses the result, finds the folders of the shaders, and reads the sizes
// of the files that its resources name. Adds the searched files to `searched`, if it is not null.
[[nodiscard]] Result<GraphDesc> parse_tier(const JsonDoc& document, const std::string& tier,
                                           const LoadSettings& settings,
                                           std::set<std::filesystem::path>* searched = nullptr);
// Compiles all shaders that passes of the graph name. If passes of different types name the same shader, the
// shader is compiled once for each type. A shader fits only one type, so compiling it for any other type adds
// an error to `faults`.
[[nodiscard]] ShaderCatalog compile_shaders(const GraphDesc& graph, const LoadInput& input,
                                            Diagnostics& faults);
[[nodiscard]] ResolveInput resolve_input(const GraphDesc& desc, const ShaderCatalog& shaders,
                                         const LoadInput& input, const SkippedFormats& skipped);
// Resolves the graph. `skipped` gives for each image how many of its alternative formats are not used,
// counted from the first. For example, 1 excludes rg16_snorm from "rg16_snorm|rg16f".
[[nodiscard]] Result<ResolvedGraph> resolve_formats(const GraphDesc& desc, const ShaderCatalog& shaders,
                                                    const LoadInput& input, const SkippedFormats& skipped,
                                                    Diagnostics& warnings);

}  // namespace weft
