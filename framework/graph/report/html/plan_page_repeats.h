// Purpose: decides which repeats the page's graph draws as one box, and builds the graph of boxes.
#pragma once

#include <string>
#include <vector>

#include "graph/report/html/plan_page.h"

namespace weft {

// A box of the graph: one pass, or all iterations of a repeat.
struct GraphNode {
    std::string name;
    std::vector<PassId> passes;
    uint32_t repeat = kNoId;  // Index into PlanPage::repeats; kNoId for a single pass.
};

// A line of the graph: all edges of one kind between two nodes.
struct GraphLink {
    uint32_t from = 0;
    uint32_t to = 0;
    EdgeKind kind = EdgeKind::raw;
    bool history = false;
    std::vector<size_t> edges;  // Indices into PlanPage::edges.
    std::vector<ResourceId> resources;
};

struct NodeGraph {
    std::vector<GraphNode> nodes;  // Live passes in schedule order, then culled passes.
    std::vector<GraphLink> links;  // First links within a frame, then links to a later frame.
};

// Returns the repeats with many iterations that can be drawn as one box. Leaves out a repeat whose iterations
// run on several queues. Also leaves out a repeat whose box would be part of a cycle. Example: another pass
// depends on the first iteration, and the second iteration depends on that pass.
[[nodiscard]] std::vector<RepeatItem> find_long_repeats(const PlanPage& page);
// Builds the graph. If `folded` is true, each entry of PlanPage::repeats is one node; otherwise every pass is
// a node.
[[nodiscard]] NodeGraph make_node_graph(const PlanPage& page, bool folded);

}  // namespace weft
