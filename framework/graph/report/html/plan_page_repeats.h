// Purpose: which repeats the page's graph draws as one box, and the graph of boxes that follows from that.
#pragma once

#include <string>
#include <vector>

#include "graph/report/html/plan_page.h"

namespace weft {

// A pass, or all rounds of a repeat.
struct GraphNode {
    std::string name;
    std::vector<PassId> passes;
    uint32_t repeat = kNoId;  // of PlanPage::repeats
};

// All edges of one kind between two nodes.
struct GraphLink {
    uint32_t from = 0;
    uint32_t to = 0;
    EdgeKind kind = EdgeKind::raw;
    bool history = false;
    std::vector<size_t> edges;  // of PlanPage::edges
    std::vector<ResourceId> resources;
};

struct NodeGraph {
    std::vector<GraphNode> nodes;  // as they run, then what was culled
    std::vector<GraphLink> links;  // those within a frame come first
};

// Repeats of many rounds. Left out are those that would close a cycle as one box: other passes run between
// their rounds.
[[nodiscard]] std::vector<RepeatItem> find_long_repeats(const PlanPage& page);
// `folded`: each of PlanPage::repeats is one node; otherwise every pass is.
[[nodiscard]] NodeGraph make_node_graph(const PlanPage& page, bool folded);

}  // namespace weft
