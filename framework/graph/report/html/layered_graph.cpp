#include "graph/report/html/layered_graph.h"

#include <algorithm>
#include <map>
#include <numeric>

namespace weft {
namespace {

constexpr int32_t kLineHeight_px = 6;  // Height of a dummy node, which reserves space for edges.
// Maximum number of dummy nodes in a graph. If a graph needs more, its longest edges get no dummy nodes.
// These edges lead directly from box to box, even across other boxes. Nobody can follow so many lines by eye
// anyway.
constexpr size_t kMostDummyNodes = 6000;

// Assigns a layer to each box: the length of the longest path to it. Exception: a box without incoming edges
// gets the layer directly before the first layer to which one of its edges leads.
std::vector<uint32_t> find_layers(size_t boxes, const std::vector<LayoutEdge>& edges) {
    std::vector<uint32_t> layer(boxes, 0), before(boxes, 0);
    std::vector<std::vector<uint32_t>> after(boxes);
    for (const LayoutEdge& e : edges) {
        after[e.from].push_back(e.to);
        ++before[e.to];
    }
    std::vector<uint32_t> ready, sources;
    for (uint32_t box = 0; box < boxes; ++box)
        if (before[box] == 0) ready.push_back(box);
    sources = ready;
    for (size_t i = 0; i < ready.size(); ++i)
        for (const uint32_t to : after[ready[i]]) {
            layer[to] = std::max(layer[to], layer[ready[i]] + 1);
            if (--before[to] == 0) ready.push_back(to);
        }
    for (const uint32_t source : sources) {
        uint32_t first = UINT32_MAX;
        for (const uint32_t to : after[source]) first = std::min(first, layer[to]);
        if (first != UINT32_MAX) layer[source] = first - 1;
    }
    return layer;
}

// Returns the largest span of an edge that still gets dummy nodes. The span is the layer of `to` minus the
// layer of `from`. Edges with a larger span get no dummy nodes.
uint32_t longest_span(const std::vector<uint32_t>& layer, const std::vector<LayoutEdge>& edges) {
    std::map<uint32_t, size_t> by_span;
    for (const LayoutEdge& e : edges) ++by_span[layer[e.to] - layer[e.from]];
    size_t dummies = 0;
    for (const auto& [span, count] : by_span) {
        dummies += (span - 1) * count;
        if (dummies > kMostDummyNodes) return span - 1;
    }
    return UINT32_MAX;
}

void connect(LayeredGraph& graph, uint32_t a, uint32_t b) {
    std::vector<uint32_t>& after = graph.nodes[a].after;
    if (std::find(after.begin(), after.end(), b) != after.end()) return;
    after.push_back(b);
    graph.nodes[b].before.push_back(a);
}

// Creates the dummy nodes of edges, one in each layer between the two boxes of an edge. Edges that start at
// the same box share one dummy node per layer. So their lines run together at first, and each line separates
// from the others directly before the layer of its target box.
class DummyNodes {
 public:
    explicit DummyNodes(LayeredGraph& graph) : graph_(graph) {}

    void lead(size_t edge, uint32_t from, uint32_t to) {
        uint32_t last = from;
        for (uint32_t layer = graph_.nodes[from].layer + 1; layer < graph_.nodes[to].layer; ++layer) {
            const uint32_t node = at(from, layer);
            connect(graph_, last, node);
            graph_.ways[edge].push_back(node);
            last = node;
        }
        connect(graph_, last, to);
    }

 private:
    uint32_t at(uint32_t from, uint32_t layer) {
        const auto [it, added] =
            known_.try_emplace({from, layer}, static_cast<uint32_t>(graph_.nodes.size()));
        if (added) graph_.nodes.push_back({UINT32_MAX, layer, kLineHeight_px, {}, {}, 0});
        return it->second;
    }
    LayeredGraph& graph_;
    std::map<std::pair<uint32_t, uint32_t>, uint32_t> known_;
};

// Returns how many pairs of edges between `layer` and the next layer cross each other. This is the number of
// inversions in the order of the edges' ends, counted with a Fenwick tree.
size_t crossings(const LayeredGraph& graph, const std::vector<uint32_t>& layer,
                 const std::vector<uint32_t>& place) {
    std::vector<uint32_t> ends;
    for (const uint32_t node : layer) {
        std::vector<uint32_t> own;
        for (const uint32_t to : graph.nodes[node].after) own.push_back(place[to]);
        std::sort(own.begin(), own.end());
        ends.insert(ends.end(), own.begin(), own.end());
    }
    const uint32_t size = ends.empty() ? 0 : *std::max_element(ends.begin(), ends.end()) + 1;
    std::vector<size_t> tree(size + 1, 0);
    size_t count = 0;
    for (size_t i = 0; i < ends.size(); ++i) {
        size_t before = 0;
        for (uint32_t k = ends[i] + 1; k > 0; k &= k - 1) before += tree[k];
        count += i - before;
        for (uint32_t k = ends[i] + 1; k <= size; k += k & (~k + 1)) ++tree[k];
    }
    return count;
}

// Returns the place of each node in its layer, counted from the top. Index: node.
std::vector<uint32_t> places(const LayeredGraph& graph) {
    std::vector<uint32_t> place(graph.nodes.size(), 0);
    for (const std::vector<uint32_t>& layer : graph.layers)
        for (uint32_t i = 0; i < layer.size(); ++i) place[layer[i]] = i;
    return place;
}

size_t all_crossings(const LayeredGraph& graph) {
    const std::vector<uint32_t> place = places(graph);
    size_t count = 0;
    for (const std::vector<uint32_t>& layer : graph.layers) count += crossings(graph, layer, place);
    return count;
}

// Sorts the nodes of a layer by the average position of their neighbours in the previous layer (`by_before`)
// or in the next layer. A node without such neighbours is sorted by its own current position.
void sort_layer(LayeredGraph& graph, std::vector<uint32_t>& layer, bool by_before,
                std::vector<uint32_t>& place) {
    std::vector<std::pair<double, uint32_t>> keyed;
    for (const uint32_t node : layer) {
        const std::vector<uint32_t>& beside = by_before ? graph.nodes[node].before : graph.nodes[node].after;
        double sum = 0;
        for (const uint32_t n : beside) sum += place[n];
        keyed.emplace_back(beside.empty() ? place[node] : sum / static_cast<double>(beside.size()), node);
    }
    std::stable_sort(keyed.begin(), keyed.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    for (uint32_t i = 0; i < keyed.size(); ++i) {
        layer[i] = keyed[i].second;
        place[layer[i]] = i;
    }
}

}  // namespace

LayeredGraph make_layers(const std::vector<LayoutBox>& boxes, const std::vector<LayoutEdge>& edges) {
    const std::vector<uint32_t> layer = find_layers(boxes.size(), edges);
    LayeredGraph graph;
    for (uint32_t box = 0; box < boxes.size(); ++box)
        graph.nodes.push_back({box, layer[box], boxes[box].height_px, {}, {}, 0});
    graph.ways.resize(edges.size());
    const uint32_t longest = longest_span(layer, edges);
    DummyNodes dummies(graph);
    for (size_t e = 0; e < edges.size(); ++e)
        if (layer[edges[e].to] - layer[edges[e].from] <= longest) dummies.lead(e, edges[e].from, edges[e].to);
    for (uint32_t node = 0; node < graph.nodes.size(); ++node) {
        const uint32_t its = graph.nodes[node].layer;
        if (graph.layers.size() <= its) graph.layers.resize(its + 1);
        graph.layers[its].push_back(node);
    }
    return graph;
}

void order_layers(LayeredGraph& graph) {
    constexpr int kSweeps = 8;
    std::vector<std::vector<uint32_t>> best = graph.layers;
    size_t fewest = all_crossings(graph);
    for (int sweep = 0; sweep < kSweeps && fewest > 0; ++sweep) {
        std::vector<uint32_t> place = places(graph);
        const size_t count = graph.layers.size();
        for (size_t i = 0; i < count; ++i)
            sort_layer(graph, graph.layers[sweep % 2 == 0 ? i : count - 1 - i], sweep % 2 == 0, place);
        if (const size_t now = all_crossings(graph); now < fewest) {
            fewest = now;
            best = graph.layers;
        }
    }
    graph.layers = std::move(best);
}

}  // namespace weft
