// Purpose: checks a graph file without a tier and with each of its tiers, and reports each cause once.
#pragma once

#include <optional>
#include <string>

#include "viewer/commands/offline_graph.h"

namespace weft::viewer {

struct CheckedGraph {
    Diagnostics found;              // messages of all tiers; Diagnostic::tier is the first tier with the
                                    // message
    size_t tiers = 0;               // number of tiers, not counting the file without a tier
    std::optional<FramePlan> plan;  // plan of the requested tier, or of the file without a tier
};

// Checks all tiers, or only the one in `options`.
[[nodiscard]] CheckedGraph check_tiers(const std::string& file, const OfflineOptions& options);

}  // namespace weft::viewer
