#include <algorithm>
#include <numeric>
#include <utility>

#include "graph/schedule/schedule_candidates.h"

namespace weft {
namespace {

template <class Row, class Item>
using Pairs = std::vector<std::pair<Row, Item>>;

// Builds the rows with a counting sort. Items of one row keep the order that they have in `pairs`.
template <class Row, class Item>
Rows<Item> make_rows(size_t row_count, const Pairs<Row, Item>& pairs) {
    Rows<Item> rows;
    rows.offsets.assign(row_count + 1, 0);
    rows.items.resize(pairs.size());
    for (const auto& [row, item] : pairs) ++rows.offsets[row + 1];
    std::partial_sum(rows.offsets.begin(), rows.offsets.end(), rows.offsets.begin());
    std::vector<uint32_t> next(rows.offsets.begin(), rows.offsets.end() - 1);
    for (const auto& [row, item] : pairs) rows.items[next[row]++] = item;
    return rows;
}

template <class A, class B>
Pairs<B, A> swap_pairs(const Pairs<A, B>& pairs) {
    Pairs<B, A> swapped;
    for (const auto& [a, b] : pairs) swapped.emplace_back(b, a);
    return swapped;
}

std::vector<uint32_t> ranks(const ResolvedGraph& graph) {
    std::vector<PassId> by_key(graph.passes.size());
    std::iota(by_key.begin(), by_key.end(), PassId(0));
    // Ids are sorted by name, so the stable sort orders passes with equal keys by name.
    std::stable_sort(by_key.begin(), by_key.end(), [&](PassId a, PassId b) {
        return graph.passes[a].order_key < graph.passes[b].order_key;
    });
    std::vector<uint32_t> rank(graph.passes.size());
    for (uint32_t i = 0; i < by_key.size(); ++i) rank[by_key[i]] = i;
    return rank;
}

Pairs<PassId, ResourceId> touched_transients(const ResolvedGraph& graph, const LiveGraph& live) {
    Pairs<PassId, ResourceId> touched;
    for (PassId pass(0); pass < graph.passes.size(); ++pass) {
        if (!live.live_passes[pass]) continue;
        const auto first = static_cast<std::ptrdiff_t>(touched.size());
        for (const UseDecl& use : graph.passes[pass].uses)
            if (graph.resources[use.resource].lifetime == ResourceLifetime::transient)
                touched.emplace_back(pass, use.resource);
        std::sort(touched.begin() + first, touched.end());
        touched.erase(std::unique(touched.begin() + first, touched.end()), touched.end());
    }
    return touched;
}

}  // namespace

ScheduleProblem schedule_problem(const ResolvedGraph& graph, const LiveGraph& live,
                                 const MemoryNeeds& needs) {
    ScheduleProblem problem;
    problem.live = live.live_passes;
    problem.rank = ranks(graph);
    Pairs<PassId, PassId> edges;
    for (const EdgeDecl& edge : graph.edges) edges.emplace_back(edge.from, edge.to);
    problem.successors = make_rows(graph.passes.size(), edges);
    problem.predecessors = make_rows(graph.passes.size(), swap_pairs(edges));
    const Pairs<PassId, ResourceId> touched = touched_transients(graph, live);
    problem.resources = make_rows(graph.passes.size(), touched);
    problem.users = make_rows(graph.resources.size(), swap_pairs(touched));
    for (const MemoryNeed& need : needs) problem.size_bytes.push_back(need.size_bytes);
    problem.size_bytes.resize(graph.resources.size(), 0);
    return problem;
}

}  // namespace weft
