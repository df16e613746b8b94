#include "graph/schedule/gather_groups.h"

#include <algorithm>
#include <functional>
#include <queue>

namespace weft {
namespace {

// Sorts blocks topologically. A block is one group, or one pass without a group. If several blocks are ready,
// takes the block whose first pass comes earliest in the given order.
class BlockSorter {
 public:
    BlockSorter(const ResolvedGraph& graph, const ScheduleProblem& problem, const std::vector<PassId>& order)
        : graph_(graph), problem_(problem), rank_(graph.passes.size(), UINT32_MAX), block_(rank_.size()) {
        for (uint32_t i = 0; i < order.size(); ++i) rank_[order[i]] = i;
        const auto groups = static_cast<uint32_t>(graph.groups.size());
        for (PassId pass(0); pass < block_.size(); ++pass) {
            const GroupDecl* group = find_group(graph, graph.passes[pass].rest_unit);
            block_[pass] =
                group == nullptr ? groups + pass : static_cast<uint32_t>(group - graph.groups.data());
        }
        passes_.resize(groups + block_.size());
        for (const PassId pass : order) passes_[block_[pass]].push_back(pass);
        for (uint32_t group = 0; group < groups; ++group)
            std::ranges::stable_sort(passes_[group], {},
                                     [&](PassId pass) { return graph.passes[pass].rest_unit; });
    }

    std::vector<PassId> run() {
        // Culled passes are sorted, too, because paths of edges lead through them. The result contains only
        // live passes.
        for (PassId pass(0); pass < block_.size(); ++pass)
            if (!problem_.live[pass]) passes_[block_[pass]].push_back(pass);
        std::vector<uint32_t> waiting(passes_.size(), 0);
        each_edge([&](uint32_t, uint32_t to) { ++waiting[to]; });
        Rows<uint32_t> next = make_rows<uint32_t>(passes_.size(), [&](const auto& add) { each_edge(add); });
        using Entry = std::pair<uint32_t, uint32_t>;
        std::priority_queue<Entry, std::vector<Entry>, std::greater<>> ready;
        for (uint32_t block = 0; block < passes_.size(); ++block)
            if (waiting[block] == 0 && !passes_[block].empty()) ready.emplace(rank_of(block), block);
        std::vector<PassId> order;
        while (!ready.empty()) {
            const uint32_t block = ready.top().second;
            ready.pop();
            for (const PassId pass : passes_[block])
                if (problem_.live[pass]) order.push_back(pass);
            for (const uint32_t to : next[block])
                if (--waiting[to] == 0) ready.emplace(rank_of(to), to);
        }
        return order;
    }

 private:
    // A block without a live pass gets rank 0, so it is taken at once. It adds no pass to the order, but
    // other blocks may wait for it.
    [[nodiscard]] uint32_t rank_of(uint32_t block) const {
        uint32_t rank = UINT32_MAX;
        for (const PassId pass : passes_[block]) rank = std::min(rank, rank_[pass]);
        return rank == UINT32_MAX ? 0 : rank;
    }

    template <class Visit>
    void each_edge(const Visit& visit) const {
        for (PassId pass(0); pass < block_.size(); ++pass)
            for (const PassId to : problem_.successors[pass])
                if (block_[pass] != block_[to]) visit(block_[pass], block_[to]);
    }

    const ResolvedGraph& graph_;
    const ScheduleProblem& problem_;
    // Index: PassId. The place of the pass in the given order; UINT32_MAX if it is culled.
    std::vector<uint32_t> rank_;
    // Index: PassId. The block of the pass. Groups have the lowest block numbers.
    std::vector<uint32_t> block_;
    std::vector<std::vector<PassId>> passes_;  // Index: block. The passes in the order in which they run.
};

}  // namespace

std::vector<PassId> gather_groups(const ResolvedGraph& graph, const ScheduleProblem& problem,
                                  const std::vector<PassId>& order) {
    return BlockSorter(graph, problem, order).run();
}

}  // namespace weft
