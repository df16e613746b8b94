// Purpose: the checks and warnings of resolve(). They find faults, and add nothing to the graph but what
// faults make suspect.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "graph/resolve/version.h"

namespace weft {

// Shaders' declarations against formats, dimensions and sizes of what is bound; one layout for each
// subresource in one pass. Errors: W105, W163, W164, W166, W172, W173, W182.
[[nodiscard]] Suspects check_interfaces(const Declared& declared, const FormattedGraph& graph,
                                        Reporter& reporter);
// Passes that take turns (`perFrame`) repeat something, and write what stays. Errors: W124.
[[nodiscard]] Suspects check_turns(const Declared& declared, const FormattedGraph& graph, Suspects suspects,
                                   Reporter& reporter);
// Clear values against the formats of what they clear. Errors: W109.
void check_clear_values(const Declared& declared, const VersionedGraph& graph, const Suspects& suspects,
                        Reporter& reporter);
// Some pass writes the output. Errors: W184.
void check_output(const Declared& declared, const VersionedGraph& graph, const Suspects& suspects,
                  Reporter& reporter);
// Parameters of C++ passes, which the result has, and what their types say of them. Errors: W113, and the
// types' own.
[[nodiscard]] ResolvedGraph check_custom_passes(const Declared& declared, ResolvedGraph graph,
                                                Suspects suspects, Reporter& reporter);
// What compiling and proving the graph will cost is within graph.steps. Errors: W125.
void weigh_plan(const ResolvedGraph& graph, Reporter& reporter);

// Resources that no pass names. Warnings: W130.
void warn_unused(const Declared& declared, Reporter& reporter);
// What is done for nothing. Warnings: W135, W136.
void warn_useless(const Declared& declared, const VersionedGraph& versioned, const ResolvedGraph& graph,
                  const Suspects& suspects, Reporter& reporter);
// What it costs to change each parameter. Warnings, for names that nothing uses: W132 to W134.
[[nodiscard]] std::vector<GraphParam> weigh_params(const ResolveInput& input, std::vector<GraphParam> params,
                                                   Reporter& reporter);

// The resources that debug views show and tests look at, by name.
[[nodiscard]] std::set<std::string, std::less<>> watched_resources(const GraphDesc& graph);
// In a file that another one includes: it may offer what this graph has no use for.
[[nodiscard]] bool is_included(const SourceMap& sources, SourceLoc loc);

}  // namespace weft
