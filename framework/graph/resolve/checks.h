// Purpose: the checks and warnings of resolve().
#pragma once

#include <vector>

#include "graph/resolve/version.h"

namespace weft {

// Checks that the declarations of shaders fit the formats, dimensions and sizes of the bound resources, and
// that each subresource has one layout in a pass. Errors: W105, W163, W164, W166, W172, W173, W182.
[[nodiscard]] Suspects check_interfaces(const Declared& declared, const FormattedGraph& graph,
                                        Reporter& reporter);
// Checks that passes that take turns (`perFrame`) are a repeat, and write resources whose content is
// preserved. Errors: W124.
[[nodiscard]] Suspects check_turns(const Declared& declared, const FormattedGraph& graph, Suspects suspects,
                                   Reporter& reporter);
// Checks that the formats of resources can store their clear values. Errors: W109.
void check_clear_values(const Declared& declared, const VersionedGraph& graph, const Suspects& suspects,
                        Reporter& reporter);
// Checks that a pass writes the output. Errors: W184.
void check_output(const Declared& declared, const VersionedGraph& graph, const Suspects& suspects,
                  Reporter& reporter);
// Adds the parameters of C++ passes to the graph, and runs the checks of their types. Errors: W113, and those
// of the types.
[[nodiscard]] ResolvedGraph check_custom_passes(const Declared& declared, ResolvedGraph graph,
                                                Suspects suspects, Reporter& reporter);
// Checks that compiling and checking the graph stays within graph.steps. Errors: W125.
void weigh_plan(const ResolvedGraph& graph, Reporter& reporter);

// Warns about resources that no pass names. Warnings: W130.
void warn_unused(const Declared& declared, Reporter& reporter);
// Warns about resources that no pass reads, and passes without effect. Warnings: W135, W136.
void warn_useless(const Declared& declared, const VersionedGraph& versioned, const ResolvedGraph& graph,
                  const Suspects& suspects, Reporter& reporter);
// Fills in the cost of changing each parameter. Warnings, for unused names: W132 to W134.
[[nodiscard]] std::vector<GraphParam> weigh_params(const ResolveInput& input, std::vector<GraphParam> params,
                                                   Reporter& reporter);

// True if the place is in an included file, which may declare more than this graph uses.
[[nodiscard]] bool is_included(const SourceMap& sources, SourceLoc loc);

}  // namespace weft
