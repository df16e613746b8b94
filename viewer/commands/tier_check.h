// Purpose: checks a graph file without a tier and with each of its tiers. The same message in several tiers
// is reported only once.
#pragma once

#include <optional>
#include <string>

#include "viewer/commands/offline_graph.h"

namespace weft::viewer {

struct CheckedGraph {
    // Messages of all tiers. In each message, Diagnostic::tier names the first tier that has the message.
    Diagnostics found;
    // Number of tiers in the file; 0 if the options name a tier. The file without a tier is also checked, but
    // not counted.
    size_t tiers = 0;
    // Plan of the requested tier. If no tier was requested: the plan of the file without a tier or, if this
    // has errors, of the first tier without errors. Absent if nothing could be compiled.
    std::optional<FramePlan> plan;
};

// Checks the graph file with all tiers. If `options` names a tier, only this tier is checked.
[[nodiscard]] CheckedGraph check_tiers(const std::string& file, const OfflineOptions& options);

}  // namespace weft::viewer
