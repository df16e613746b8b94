// Purpose: reads the name of a graph and of one of its tiers from the command line: "FILE.json:TIER".
#pragma once

#include <string>

namespace weft::viewer {

struct GraphName {
    std::string graph;
    std::string tier;  // Empty: none is named.
};

// Returns the part before the last colon and the tier after it. If a file has the whole text as its name, or if
// the colon is in the name of a folder, the text has no tier.
[[nodiscard]] GraphName read_graph_name(const std::string& text);

}  // namespace weft::viewer
