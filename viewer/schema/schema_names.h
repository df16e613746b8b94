// Purpose: collects the names that a graph declares and the names that its shaders use. The file is read
// without a tier and with each tier. Errors in the graph are ignored, so that the schema is useful while the
// user edits the file. Errors: those of reading the file (W001 to W005, W126, W127).
#pragma once

#include <map>
#include <set>
#include <string>

#include "viewer/options/options.h"
#include "weft/result.h"

namespace weft::viewer {

// The names that a pass may bind. They come from its shader, or from its pass type in C++.
struct PassNames {
    std::set<std::string> in, out;
    std::set<std::string> params, constants;
    std::set<std::string> attachments;  // Outputs that the graph file declares in the pass.
    bool is_open = false;  // True if the shader cannot be read in some tier. Then any name is accepted.
};

struct GraphNames {
    std::set<std::string> resources, draw_lists, params, tiers;
    std::map<std::string, PassNames> passes;
    // Names of shaders in the folder of the graph, or shipped with Weft.
    std::set<std::string> compute_shaders, fullscreen_shaders, raster_shaders;
};

[[nodiscard]] Result<GraphNames> gather_names(const SchemaOptions& options);

}  // namespace weft::viewer
