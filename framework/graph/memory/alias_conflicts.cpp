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

// Returns all pairs of items whose lifetimes overlap. The item that begins later is the first of each pair.
std::vector<Pair> overlaps(const std::vector<PackItem>& items, const std::vector<uint32_t>& starts,
                           const QueueTimes* times, uint64_t count) {
    std::vector<Pair> pairs;
    pairs.reserve(count);
    std::vector<uint32_t> active;
    for (const uint32_t i : starts) {
        size_t kept = 0;
        for (const uint32_t other : active)
            if (items[other].last >= items[i].first) active[kept++] = other;
        active.resize(kept);
        for (const uint32_t other : active)
            if (times == nullptr || times->may_overlap(other, i)) pairs.emplace_back(i, other);
        active.push_back(i);
    }
    return pairs;
}

}  // namespace

Conflicts::Conflicts(const std::vector<PackItem>& items, const QueueTimes* times)
    : items_(items), times_(times) {
    const std::vector<uint32_t> starts = by_start(items);
    const uint64_t count = count_overlaps(items, starts);
    dense_ = count * 2 * kDenseFactor > static_cast<uint64_t>(items.size()) * items.size();
    if (!dense_) {
        const std::vector<Pair> pairs = overlaps(items, starts, times, count);
        neighbours_ = make_rows<uint32_t>(items.size(), [&](const auto& add) {
            for (const auto& [a, b] : pairs) {
                add(a, b);
                add(b, a);
            }
        });
    }
    taken_.resize(items.size());
    clear();
}

bool Conflicts::overlap(uint32_t a, uint32_t b) const {
    const PackItem &one = items_[a], &other = items_[b];
    const bool overlap = (one.first <= other.last) & (other.first <= one.last);
    if (times_ == nullptr || !overlap) return overlap;
    return one.first <= other.first ? times_->may_overlap(a, b) : times_->may_overlap(b, a);
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

std::span<const TakenSpan> Conflicts::taken(uint32_t item) {
    size_t count = 0;
    if (dense_) {
        // Writes each span, and increments the count only if the items overlap. Otherwise, the next span
        // overwrites this one. A branch would often be mispredicted, because overlaps follow no pattern.
        for (const TakenSpan& p : placed_) {
            taken_[count] = p;
            count += overlap(item, p.item) ? 1 : 0;
        }
        return std::span(taken_).first(count);
    }
    for (const uint32_t other : neighbours_[item]) {
        const uint64_t begin = offsets_bytes_[other];
        if (begin != kUnplaced) taken_[count++] = {begin, begin + items_[other].size_bytes, other};
    }
    const std::span<TakenSpan> found = std::span(taken_).first(count);
    std::ranges::sort(found, {}, &TakenSpan::begin_bytes);
    return found;
}

}  // namespace weft
