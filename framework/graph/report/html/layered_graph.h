// Purpose: the graph on which layered_layout() works. Its nodes are boxes and dummy nodes. A dummy node
// reserves space in a layer for edges that cross this layer.
#pragma once

#include <vector>

#include "graph/report/html/layered_layout.h"

namespace weft {

struct LayerNode {
    uint32_t box = UINT32_MAX;  // Index of the box; UINT32_MAX for a dummy node.
    uint32_t layer = 0;
    int32_t height_px = 0;
    std::vector<uint32_t> before, after;  // Neighbours in the previous and in the next layer.
    double y_px = 0;                      // Vertical position of the node's centre.
};

struct LayeredGraph {
    std::vector<LayerNode> nodes;               // First all boxes, then the dummy nodes of edges.
    std::vector<std::vector<uint32_t>> layers;  // The nodes of each layer, from top to bottom.
    // Index: edge. The dummy nodes on the edge's path, in order; empty if it has none.
    std::vector<std::vector<uint32_t>> ways;
};

[[nodiscard]] LayeredGraph make_layers(const std::vector<LayoutBox>& boxes,
                                       const std::vector<LayoutEdge>& edges);
// Sorts the nodes of each layer so that few edges cross.
void order_layers(LayeredGraph& graph);
// Sets the vertical position of every node as close to that of its neighbours as possible, without changing
// the order in the layer.
void place_nodes(LayeredGraph& graph);

}  // namespace weft
