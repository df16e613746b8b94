#include "graph/report/html/layered_layout.h"

#include <algorithm>
#include <cmath>

#include "graph/report/html/layered_graph.h"

namespace weft {
namespace {

struct LayerSpan {
    int32_t left_px = 0;
    int32_t width_px = 0;
};

std::vector<LayerSpan> layer_spans(const LayeredGraph& graph, const std::vector<LayoutBox>& boxes,
                                   int32_t gap_px) {
    std::vector<LayerSpan> spans;
    int32_t x_px = 0;
    for (const std::vector<uint32_t>& layer : graph.layers) {
        LayerSpan span{x_px, 0};
        for (const uint32_t node : layer)
            if (node < boxes.size()) span.width_px = std::max(span.width_px, boxes[node].width_px);
        x_px += span.width_px + gap_px;
        spans.push_back(span);
    }
    return spans;
}

int32_t rounded(double value) {
    return static_cast<int32_t>(std::lround(value));
}

}  // namespace

LayeredLayout layered_layout(const std::vector<LayoutBox>& boxes, const std::vector<LayoutEdge>& edges,
                             int32_t layer_gap_px) {
    LayeredGraph graph = make_layers(boxes, edges);
    order_layers(graph);
    place_nodes(graph);
    if (graph.nodes.empty()) return {};
    double top_px = graph.nodes[0].y_px, bottom_px = top_px;
    for (const LayerNode& node : graph.nodes) {
        top_px = std::min(top_px, node.y_px - node.height_px / 2.0);
        bottom_px = std::max(bottom_px, node.y_px + node.height_px / 2.0);
    }
    const std::vector<LayerSpan> spans = layer_spans(graph, boxes, layer_gap_px);
    LayeredLayout layout;
    for (uint32_t box = 0; box < boxes.size(); ++box) {
        const LayerNode& node = graph.nodes[box];
        layout.boxes.push_back(
            {spans[node.layer].left_px, rounded(node.y_px - boxes[box].height_px / 2.0 - top_px)});
    }
    for (const std::vector<uint32_t>& way : graph.ways) {
        std::vector<PointPx> bends;
        for (const uint32_t node : way) {
            const LayerSpan& span = spans[graph.nodes[node].layer];
            const int32_t y_px = rounded(graph.nodes[node].y_px - top_px);
            bends.push_back({span.left_px, y_px});
            bends.push_back({span.left_px + span.width_px, y_px});
        }
        layout.bends.push_back(std::move(bends));
    }
    layout.width_px = spans.empty() ? 0 : spans.back().left_px + spans.back().width_px;
    layout.layers = static_cast<uint32_t>(spans.size());
    layout.height_px = rounded(bottom_px - top_px);
    return layout;
}

}  // namespace weft
