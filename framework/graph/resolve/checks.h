// Purpose: declares the checks of resolve(), which report errors and warnings. Two of the functions also
// compute results: check_custom_passes() and weigh_params().
#pragma once

#include <vector>

#include "graph/resolve/version.h"

namespace weft {

// Checks that the shaders' declarations fit the formats, dimensions and sizes of the bound resources, and
// that each subresource has one layout and at most one writing port during a pass. Errors: W105, W163, W164,
// W166, W172, W173, W182, W187, W194.
[[nodiscard]] Suspects check_interfaces(const Declared& declared, const FormattedGraph& graph,
                                        Reporter& reporter);
// Checks the passes with `perFrame`. The value is the number of passes of a repeat that run in each frame. So
// a pass with `perFrame` must have a `repeat`. It must also write resources that keep their content between
// frames. Errors: W124.
[[nodiscard]] Suspects check_frame_slices(const Declared& declared, const FormattedGraph& graph,
                                          Suspects suspects, Reporter& reporter);
// Checks that the clear values of resources and passes fit the formats of the cleared resources. Errors:
// W109.
void check_clear_values(const Declared& declared, const VersionedGraph& graph, const Suspects& suspects,
                        Reporter& reporter);
// Checks that at least one pass writes the output image of the graph. Errors: W184.
void check_output(const Declared& declared, const VersionedGraph& graph, const Suspects& suspects,
                  Reporter& reporter);
// Adds the parameters of C++ passes to the graph, and calls the check function of each C++ pass type. Errors:
// W113, and the errors of the check functions.
[[nodiscard]] ResolvedGraph check_custom_passes(const Declared& declared, ResolvedGraph graph,
                                                Suspects suspects, Reporter& reporter);
// Checks that compiling and checking the graph takes at most as many steps as the limit graph.steps allows.
// Errors: W125.
void weigh_plan(const ResolvedGraph& graph, Reporter& reporter);

// Warns about resources that no pass names. Warnings: W130.
void warn_unused(const Declared& declared, Reporter& reporter);
// Warns about resources that no pass reads, and about passes that have no effect. Warnings: W135, W136.
void warn_useless(const Declared& declared, const VersionedGraph& versioned, const ResolvedGraph& graph,
                  const Suspects& suspects, Reporter& reporter);
// Warns about passes with "rest" whose shader reads a value that changes in every frame. Warnings: W138.
void warn_restless(const Declared& declared, const ResolvedGraph& graph, Reporter& reporter);
// Fills in how much work a change of each parameter causes. Also warns about names that nothing uses.
// Warnings: W132 to W134.
[[nodiscard]] std::vector<GraphParam> weigh_params(const ResolveInput& input, std::vector<GraphParam> params,
                                                   Reporter& reporter);

// Returns true if the location is in an included file. Such a file may declare more than this graph uses, so
// unused names in included files cause no warning.
[[nodiscard]] bool is_included(const SourceMap& sources, SourceLoc loc);

}  // namespace weft
