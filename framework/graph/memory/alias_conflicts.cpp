#include "graph/memory/alias_conflicts.h"

#include <algorithm>
#include <numeric>

namespace weft {
namespace {

constexpr uint64_t kUnplaced = UINT64_MAX;
// Sorting a list of conflicting items costs about this many times more per item than scanning a list that is
// already sorted. The factor decides whether conflicts are found by sorting or by scanning.
constexpr uint64_t kDenseFactor = 8;

std::vector<uint32_t> by_start(const std::vector<PackItem>& items) {
    std::vector<uint32_t> order(items.size());
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(),
                     [&](uint32_t a, uint32_t b) { return items[a].first < items[b].first; });
    return order;
}

uint64_t overlapping_pairs(const std::vector<PackItem>& items) {
    std::vector<uint32_t> ends;
    for (const PackItem& item : items) ends.push_back(item.last);
    std::sort(ends.begin(), ends.end());
    uint64_t pairs = 0, started = 0, ended = 0;
    for (const uint32_t i : by_start(items)) {
        while (ended < ends.size() && ends[ended] < items[i].first) ++ended;
        pairs += started - ended;
        ++started;
    }
    return pairs;
}

}  // namespace

Conflicts::Conflicts(const std::vector<PackItem>& items, const Unordered& unordered) : items_(items) {
    if (unordered) {
        find_neighbours(unordered);
        clear();
        return;
    }
    dense_ = overlapping_pairs(items) * 2 * kDenseFactor > static_cast<uint64_t>(items.size()) * items.size();
    if (!dense_) find_neighbours();
    clear();
}

void Conflicts::find_neighbours() {
    neighbours_.resize(items_.size());
    std::vector<uint32_t> active;
    for (const uint32_t i : by_start(items_)) {
        std::erase_if(active, [&](uint32_t other) { return items_[other].last < items_[i].first; });
        for (const uint32_t other : active) {
            neighbours_[i].push_back(other);
            neighbours_[other].push_back(i);
        }
        active.push_back(i);
    }
}

void Conflicts::find_neighbours(const Unordered& unordered) {
    neighbours_.resize(items_.size());
    for (uint32_t a = 0; a < items_.size(); ++a) {
        for (uint32_t b = 0; b < a; ++b) {
            const bool overlap = items_[a].first <= items_[b].last && items_[b].first <= items_[a].last;
            if (!overlap && !unordered(a, b)) continue;
            neighbours_[a].push_back(b);
            neighbours_[b].push_back(a);
        }
    }
}

size_t Conflicts::visits() const {
    if (dense_) return items_.size() * items_.size() / 2;
    size_t count = items_.size();
    for (const std::vector<uint32_t>& row : neighbours_) count += row.size();
    return count;
}

void Conflicts::clear() {
    placed_.clear();
    offsets_bytes_.assign(dense_ ? 0 : items_.size(), kUnplaced);
}

void Conflicts::place(uint32_t item, uint64_t offset_bytes) {
    if (!dense_) {
        offsets_bytes_[item] = offset_bytes;
        return;
    }
    const auto at =
        std::upper_bound(placed_.begin(), placed_.end(), offset_bytes,
                         [](uint64_t offset, const Placed& p) { return offset < p.offset_bytes; });
    placed_.insert(at, {offset_bytes, item});
}

const std::vector<ByteSpan>& Conflicts::taken(uint32_t item) {
    taken_.clear();
    if (dense_) {
        const PackItem& own = items_[item];
        for (const Placed& p : placed_) {
            const PackItem& other = items_[p.item];
            if (other.first <= own.last && own.first <= other.last)
                taken_.push_back({p.offset_bytes, p.offset_bytes + other.size_bytes});
        }
        return taken_;
    }
    for (const uint32_t other : neighbours_[item])
        if (offsets_bytes_[other] != kUnplaced)
            taken_.push_back({offsets_bytes_[other], offsets_bytes_[other] + items_[other].size_bytes});
    std::sort(taken_.begin(), taken_.end(),
              [](const ByteSpan& a, const ByteSpan& b) { return a.begin_bytes < b.begin_bytes; });
    return taken_;
}

}  // namespace weft
