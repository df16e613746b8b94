// Purpose: the graph that layered_layout() works on: boxes and, where an edge crosses a layer, a stand-in.
#pragma once

#include <vector>

#include "graph/report/html/layered_layout.h"

namespace weft {

struct LayerNode {
    uint32_t box = UINT32_MAX;  // UINT32_MAX: a stand-in
    uint32_t layer = 0;
    int32_t height_px = 0;
    std::vector<uint32_t> before, after;  // neighbours in the layers beside it
    double y_px = 0;                      // of its middle
};

struct LayeredGraph {
    std::vector<LayerNode> nodes;               // the boxes first
    std::vector<std::vector<uint32_t>> layers;  // nodes from top to bottom
    std::vector<std::vector<uint32_t>> ways;  // by edge: the stand-ins it goes through; none: straight ahead
};

[[nodiscard]] LayeredGraph make_layers(const std::vector<LayoutBox>& boxes,
                                       const std::vector<LayoutEdge>& edges);
// Orders each layer so that few edges cross.
void order_layers(LayeredGraph& graph);
// Gives every node its height, as level with its neighbours as its layer allows.
void place_nodes(LayeredGraph& graph);

}  // namespace weft
