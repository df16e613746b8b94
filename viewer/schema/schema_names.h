// Purpose: collects the names that a graph declares and the names that its shaders use. The file is read
// without a tier and with each tier. Most errors in the graph are ignored, so that the schema is useful while
// the user edits the file. Errors: only those of reading the file (W001 to W005, W102, W126, W127).
#pragma once

#include <map>
#include <set>
#include <string>

#include "viewer/options/options.h"
#include "weft/result.h"

namespace weft::viewer {

// The names of ports, parameters and constants that a pass may use. They come from its shader, or from its
// pass type in C++.
struct PassNames {
    std::set<std::string> in, out;
    std::set<std::string> params, constants;
    std::set<std::string> attachments;  // Outputs that the graph file declares in the pass.
    // True if the names are unknown in some tier, for example because the shader does not compile. Then any
    // name is accepted.
    bool is_open = false;
};

struct GraphNames {
    // The sets also contain the resources and the pass names of groups, each both as "raw" and as
    // "relight::raw".
    std::set<std::string> resources, pass_names;
    std::set<std::string> draw_lists, turns, views, params, tiers;
    std::map<std::string, PassNames> passes;
    // The passes of each group.
    std::map<std::string, std::map<std::string, PassNames>> groups;
    // Names of shaders in the folder of the graph, or shipped with Weft.
    std::set<std::string> compute_shaders, fullscreen_shaders, raster_shaders;
};

[[nodiscard]] Result<GraphNames> gather_names(const SchemaOptions& options);

}  // namespace weft::viewer
