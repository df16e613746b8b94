#include "null/execution_order.h"

#include <algorithm>
#include <numeric>
#include <random>
#include <utility>

namespace weft::null {
namespace {

// Returns the order in which the nodes are requested. Before a requested node, its predecessors are executed.
std::vector<uint32_t> demand(size_t count, NullOrder order, uint64_t seed) {
    std::vector<uint32_t> nodes(count);
    std::iota(nodes.begin(), nodes.end(), 0u);
    if (order == NullOrder::delayed) std::reverse(nodes.begin(), nodes.end());
    if (order != NullOrder::shuffled) return nodes;
    std::mt19937_64 random(seed);
    for (size_t i = count; i > 1; --i) std::swap(nodes[i - 1], nodes[random() % i]);
    return nodes;
}

class BatchOrder {
 public:
    explicit BatchOrder(const Timeline& timeline) : timeline_(timeline) {
        order_.reserve(timeline.nodes.size());
    }

    // Executes the predecessors of the node, then the node. All other nodes wait until they are requested.
    // Predecessors have smaller indices than the node.
    void ask_for(uint32_t node) {
        if (done_.contains(node)) return;
        std::vector<uint32_t> missing = timeline_.outside_before[node];
        timeline_.before[node].for_each_missing(done_, [&](uint32_t n) { missing.push_back(n); });
        std::sort(missing.begin(), missing.end());
        for (const uint32_t n : missing) ask_for(n);
        order_.push_back(node);
        done_.insert(node);
    }
    [[nodiscard]] std::vector<uint32_t> take() { return std::move(order_); }

 private:
    const Timeline& timeline_;
    NodeSet done_;
    std::vector<uint32_t> order_;
};

}  // namespace

std::vector<uint32_t> execution_order(const Timeline& timeline, NullOrder order, uint64_t seed) {
    BatchOrder batches(timeline);
    for (const uint32_t node : demand(timeline.nodes.size(), order, seed)) batches.ask_for(node);
    return batches.take();
}

}  // namespace weft::null
