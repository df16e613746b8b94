#include <algorithm>
#include <numeric>

#include "graph/schedule/schedule_candidates.h"

namespace weft {
namespace {

// Returns the rank of each pass when passes are sorted by (order_key, name).
std::vector<uint32_t> ranks(const ResolvedGraph& graph) {
    std::vector<PassId> by_key(graph.passes.size());
    std::iota(by_key.begin(), by_key.end(), PassId(0));
    // Ids are sorted by name, so the stable sort orders passes with equal keys by name.
    const auto earlier = [&](PassId a, PassId b) {
        return graph.passes[a].order_key < graph.passes[b].order_key;
    };
    if (!std::ranges::is_sorted(by_key, earlier)) std::stable_sort(by_key.begin(), by_key.end(), earlier);
    std::vector<uint32_t> rank(graph.passes.size());
    for (uint32_t i = 0; i < by_key.size(); ++i) rank[by_key[i]] = i;
    return rank;
}

// Returns for each pass the transients that it uses, sorted by id, without duplicates.
Rows<ResourceId> used_transients(const ResolvedGraph& graph, const LiveGraph& live) {
    Rows<ResourceId> rows;
    rows.offsets.reserve(graph.passes.size() + 1);
    rows.items.reserve(graph.edges.size() + graph.passes.size());
    for (PassId pass(0); pass < graph.passes.size(); ++pass) {
        const auto first = static_cast<std::ptrdiff_t>(rows.items.size());
        for (const UseDecl& use : graph.passes[pass].uses)
            if (live.live_passes[pass] &&
                graph.resources[use.resource].lifetime == ResourceLifetime::transient)
                rows.items.push_back(use.resource);
        std::sort(rows.items.begin() + first, rows.items.end());
        rows.items.erase(std::unique(rows.items.begin() + first, rows.items.end()), rows.items.end());
        rows.offsets.push_back(static_cast<uint32_t>(rows.items.size()));
    }
    return rows;
}

}  // namespace

ScheduleProblem schedule_problem(const ResolvedGraph& graph, const LiveGraph& live,
                                 const MemoryNeeds& needs) {
    ScheduleProblem problem;
    problem.live = live.live_passes;
    problem.rank = ranks(graph);
    problem.successors = make_rows<PassId>(graph.passes.size(), [&](const auto& add) {
        for (const EdgeDecl& edge : graph.edges) add(edge.from, edge.to);
    });
    problem.predecessors = make_rows<PassId>(graph.passes.size(), [&](const auto& add) {
        for (const EdgeDecl& edge : graph.edges) add(edge.to, edge.from);
    });
    problem.resources = used_transients(graph, live);
    problem.users = make_rows<PassId>(graph.resources.size(), [&](const auto& add) {
        for (PassId pass(0); pass < graph.passes.size(); ++pass)
            for (const ResourceId resource : problem.resources[pass]) add(resource, pass);
    });
    problem.size_bytes.assign(graph.resources.size(), 0);
    for (size_t i = 0; i < std::min(needs.size(), graph.resources.size()); ++i)
        problem.size_bytes[i] = needs[i].size_bytes;
    return problem;
}

}  // namespace weft
