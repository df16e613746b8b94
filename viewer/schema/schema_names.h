// Purpose: the names that a graph gives and the ones that its shaders ask for, gathered from the file as it
// is and from each of its tiers. Faults don't matter: what a file says so far is what its author's editor can
// use. Errors: those of reading (W001 to W005, W126, W127).
#pragma once

#include <map>
#include <set>
#include <string>

#include "viewer/options/options.h"
#include "weft/result.h"

namespace weft::viewer {

// What a pass may bind, as its shader or its C++ type says.
struct PassNames {
    std::set<std::string> in, out;
    std::set<std::string> params, constants;
    std::set<std::string> attachments;  // the outputs that the graph itself gives it
    bool is_open = false;               // a tier's shader can't be read: nobody knows what it binds
};

struct GraphNames {
    std::set<std::string> resources, draw_lists, params, tiers;
    std::map<std::string, PassNames> passes;
    std::set<std::string> compute_shaders, fullscreen_shaders,
        raster_shaders;  // beside the graph, or shipped
};

[[nodiscard]] Result<GraphNames> gather_names(const SchemaOptions& options);

}  // namespace weft::viewer
