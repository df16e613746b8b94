// Purpose: collects the names that a graph declares and those that its shaders use, from the file without a
// tier and with each tier. Faults are ignored, so that the schema is useful while the file is being edited.
// Errors: those of reading (W001 to W005, W126, W127).
#pragma once

#include <map>
#include <set>
#include <string>

#include "viewer/options/options.h"
#include "weft/result.h"

namespace weft::viewer {

// The names that a pass may bind, from its shader or its C++ type.
struct PassNames {
    std::set<std::string> in, out;
    std::set<std::string> params, constants;
    std::set<std::string> attachments;  // outputs declared by the graph itself
    bool is_open = false;               // true if a shader cannot be read in some tier, so that any name is
                                        // accepted
};

struct GraphNames {
    std::set<std::string> resources, draw_lists, params, tiers;
    std::map<std::string, PassNames> passes;
    std::set<std::string> compute_shaders, fullscreen_shaders,
        raster_shaders;  // in the graph's folder, or shipped with Weft
};

[[nodiscard]] Result<GraphNames> gather_names(const SchemaOptions& options);

}  // namespace weft::viewer
