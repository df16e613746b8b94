// Computes the vertical positions of the nodes of a layered graph.
#include <algorithm>
#include <cmath>

#include "graph/report/html/layered_graph.h"

namespace weft {
namespace {

constexpr double kBoxGap_px = 20, kLineGap_px = 10;

// Returns the minimum distance between the centres of two neighbouring nodes of a layer.
double middle_distance_px(const LayerNode& a, const LayerNode& b) {
    const bool lines = a.box == UINT32_MAX && b.box == UINT32_MAX;
    return (a.height_px + b.height_px) / 2.0 + (lines ? kLineGap_px : kBoxGap_px);
}

// Consecutive values that get the same position in settle(): the weighted average of their wanted positions.
struct Block {
    double sum = 0;
    double weight = 0;
    size_t count = 0;
    [[nodiscard]] double mean() const { return sum / weight; }
};

// Returns ascending positions that are as close as possible to the wanted positions: the weighted sum of the
// squared distances is minimal (isotonic regression). Equal positions are allowed, because the caller
// subtracts the minimum distances between the nodes before the call and adds them again after it.
std::vector<double> settle(const std::vector<double>& wanted, const std::vector<double>& weights) {
    std::vector<Block> blocks;
    for (size_t i = 0; i < wanted.size(); ++i) {
        blocks.push_back({wanted[i] * weights[i], weights[i], 1});
        while (blocks.size() > 1 && blocks[blocks.size() - 2].mean() > blocks.back().mean()) {
            const Block last = blocks.back();
            blocks.pop_back();
            blocks.back().sum += last.sum;
            blocks.back().weight += last.weight;
            blocks.back().count += last.count;
        }
    }
    std::vector<double> settled;
    for (const Block& block : blocks) settled.insert(settled.end(), block.count, block.mean());
    return settled;
}

double wanted_px(const LayeredGraph& graph, const LayerNode& node, int side) {
    double sum = 0;
    size_t count = 0;
    const auto look = [&](const std::vector<uint32_t>& beside) {
        for (const uint32_t n : beside) sum += graph.nodes[n].y_px;
        count += beside.size();
    };
    if (side <= 0) look(node.before);
    if (side >= 0) look(node.after);
    return count == 0 ? node.y_px : sum / static_cast<double>(count);
}

// Moves the nodes of a layer towards the vertical positions of their neighbours. `side` selects the
// neighbours: -1 those in the previous layer, 1 those in the next layer, 0 both.
void level(LayeredGraph& graph, const std::vector<uint32_t>& layer, int side) {
    std::vector<double> wanted, weights, offsets;
    double offset = 0;
    for (size_t i = 0; i < layer.size(); ++i) {
        const LayerNode& node = graph.nodes[layer[i]];
        if (i > 0) offset += middle_distance_px(graph.nodes[layer[i - 1]], node);
        offsets.push_back(offset);
        wanted.push_back(wanted_px(graph, node, side) - offset);
        // The dummy nodes of edges have a higher weight than boxes, so that long edges are nearly straight
        // and easy to follow.
        weights.push_back(node.box == UINT32_MAX ? 4.0 : 1.0);
    }
    const std::vector<double> settled = settle(wanted, weights);
    for (size_t i = 0; i < layer.size(); ++i) graph.nodes[layer[i]].y_px = settled[i] + offsets[i];
}

}  // namespace

void place_nodes(LayeredGraph& graph) {
    for (const std::vector<uint32_t>& layer : graph.layers) {
        double y_px = 0;
        for (size_t i = 0; i < layer.size(); ++i) {
            if (i > 0) y_px += middle_distance_px(graph.nodes[layer[i - 1]], graph.nodes[layer[i]]);
            graph.nodes[layer[i]].y_px = y_px;
        }
        for (const uint32_t node : layer) graph.nodes[node].y_px -= y_px / 2;
    }
    constexpr int kSweeps = 6;
    for (int sweep = 0; sweep < kSweeps; ++sweep) {
        for (const std::vector<uint32_t>& layer : graph.layers) level(graph, layer, -1);
        for (size_t i = graph.layers.size(); i-- > 0;) level(graph, graph.layers[i], 1);
    }
    for (size_t i = graph.layers.size(); i-- > 0;) level(graph, graph.layers[i], 0);
    for (const std::vector<uint32_t>& layer : graph.layers) level(graph, layer, 0);
}

}  // namespace weft
