// Purpose: a graph file checked as it is and in each of its tiers, with one message for each cause.
#pragma once

#include <optional>
#include <string>

#include "viewer/commands/offline_graph.h"

namespace weft::viewer {

struct CheckedGraph {
    Diagnostics found;              // of all tiers; Diagnostic::tier is the first in which it is one
    size_t tiers = 0;               // how many, besides the file as it is
    std::optional<FramePlan> plan;  // of the file as it is, or of the tier that was asked for
};

// All tiers, or the one of `options`.
[[nodiscard]] CheckedGraph check_tiers(const std::string& file, const OfflineOptions& options);

}  // namespace weft::viewer
