#include "graph/memory/alias_conflicts.h"

#include <algorithm>
#include <numeric>

namespace weft {
namespace {

using Pair = std::pair<uint32_t, uint32_t>;

constexpr uint64_t kUnplaced = UINT64_MAX;
// Sorting a list of conflicting items costs about this many times more per item than scanning a list that is
// already sorted. The factor decides whether conflicts are found by sorting or by scanning.
constexpr uint64_t kDenseFactor = 8;

std::vector<uint32_t> by_start(const std::vector<PackItem>& items) {
    std::vector<uint32_t> order(items.size());
    std::iota(order.begin(), order.end(), 0u);
    const auto earlier = [&](uint32_t a, uint32_t b) { return items[a].first < items[b].first; };
    if (!std::ranges::is_sorted(order, earlier)) std::stable_sort(order.begin(), order.end(), earlier);
    return order;
}

uint64_t count_overlaps(const std::vector<PackItem>& items, const std::vector<uint32_t>& starts) {
    std::vector<uint32_t> ends;
    ends.reserve(items.size());
    for (const PackItem& item : items) ends.push_back(item.last);
    std::ranges::sort(ends);
    uint64_t pairs = 0, started = 0, ended = 0;
    for (const uint32_t i : starts) {
        while (ended < ends.size() && ends[ended] < items[i].first) ++ended;
        pairs += started - ended;
        ++started;
    }
    return pairs;
}

// Returns all pairs of items whose lifetimes overlap.
std::vector<Pair> overlaps(const std::vector<PackItem>& items, const std::vector<uint32_t>& starts,
                           uint64_t count) {
    std::vector<Pair> pairs;
    pairs.reserve(count);
    std::vector<uint32_t> active;
    for (const uint32_t i : starts) {
        size_t kept = 0;
        for (const uint32_t other : active)
            if (items[other].last >= items[i].first) active[kept++] = other;
        active.resize(kept);
        for (const uint32_t other : active) pairs.emplace_back(i, other);
        active.push_back(i);
    }
    return pairs;
}

}  // namespace

Conflicts::Conflicts(const std::vector<PackItem>& items, const Unordered& unordered) : items_(items) {
    std::vector<Pair> pairs;
    if (unordered) {
        for (uint32_t a = 0; a < items_.size(); ++a)
            for (uint32_t b = 0; b < a; ++b) {
                const bool overlap = items_[a].first <= items_[b].last && items_[b].first <= items_[a].last;
                if (overlap || unordered(a, b)) pairs.emplace_back(a, b);
            }
    } else {
        const std::vector<uint32_t> starts = by_start(items);
        const uint64_t count = count_overlaps(items, starts);
        dense_ = count * 2 * kDenseFactor > static_cast<uint64_t>(items.size()) * items.size();
        if (!dense_) pairs = overlaps(items, starts, count);
    }
    if (!dense_) store(pairs);
    clear();
}

void Conflicts::store(const std::vector<Pair>& pairs) {
    rows_.assign(items_.size() + 1, 0);
    for (const auto& [a, b] : pairs) {
        ++rows_[a + 1];
        ++rows_[b + 1];
    }
    std::partial_sum(rows_.begin(), rows_.end(), rows_.begin());
    neighbours_.resize(2 * pairs.size());
    std::vector<uint32_t> next(rows_.begin(), rows_.end() - 1);
    for (const auto& [a, b] : pairs) {
        neighbours_[next[a]++] = b;
        neighbours_[next[b]++] = a;
    }
}

void Conflicts::clear() {
    placed_.clear();
    offsets_bytes_.assign(items_.size(), kUnplaced);
}

void Conflicts::place(uint32_t item, uint64_t offset_bytes) {
    offsets_bytes_[item] = offset_bytes;
    if (!dense_) return;
    const auto at =
        std::upper_bound(placed_.begin(), placed_.end(), offset_bytes,
                         [](uint64_t offset, const TakenSpan& p) { return offset < p.begin_bytes; });
    placed_.insert(at, {offset_bytes, offset_bytes + items_[item].size_bytes, item});
}

void Conflicts::remove(uint32_t item) {
    if (dense_) {
        auto at =
            std::lower_bound(placed_.begin(), placed_.end(), offsets_bytes_[item],
                             [](const TakenSpan& p, uint64_t offset) { return p.begin_bytes < offset; });
        while (at->item != item) ++at;
        placed_.erase(at);
    }
    offsets_bytes_[item] = kUnplaced;
}

const std::vector<TakenSpan>& Conflicts::taken(uint32_t item) {
    taken_.clear();
    if (dense_) {
        const PackItem& own = items_[item];
        for (const TakenSpan& p : placed_) {
            const PackItem& other = items_[p.item];
            if (other.first <= own.last && own.first <= other.last) taken_.push_back(p);
        }
        return taken_;
    }
    for (const uint32_t other : neighbours(item))
        if (offsets_bytes_[other] != kUnplaced)
            taken_.push_back(
                {offsets_bytes_[other], offsets_bytes_[other] + items_[other].size_bytes, other});
    std::sort(taken_.begin(), taken_.end(),
              [](const TakenSpan& a, const TakenSpan& b) { return a.begin_bytes < b.begin_bytes; });
    return taken_;
}

}  // namespace weft
