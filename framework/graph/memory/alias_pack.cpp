#include "graph/memory/alias_pack.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <span>

#include "graph/memory/alias_best_fit.h"
#include "graph/memory/alias_conflicts.h"
#include "graph/memory/alias_eject.h"

namespace weft {
namespace {

// If many pairs of items are alive together (dense, see Conflicts), the result of pack_sweep() or
// pack_sweep_back() is good enough if the heap exceeds the lower bound by at most this percentage.
constexpr uint64_t kGoodSweepPercent = 5;
// With more items than this, and if many pairs of items are alive together (dense, see Conflicts), only
// pack_sweep() and pack_sweep_back() are used, because the other methods take too long.
constexpr size_t kMaxDenseItems = 1024;
// With at most this number of items, more methods are tried: one badly placed item can waste a large share of
// the heap, and each method takes little time.
constexpr size_t kFewItems = 300;
// search() packs all items again in each round. So it is used only for at most this number of items.
constexpr size_t kMaxSearchedItems = 100;
constexpr size_t kMaxSearchRounds = 16;

uint64_t with_percent(uint64_t bytes, uint64_t percent) {
    return bytes + bytes * percent / 100;
}

std::vector<uint32_t> size_descending_order(const std::vector<PackItem>& items) {
    std::vector<uint32_t> order(items.size());
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) {
        if (items[a].size_bytes != items[b].size_bytes) return items[a].size_bytes > items[b].size_bytes;
        return items[a].first < items[b].first;
    });
    return order;
}

// Returns an order for placing the items. Items that are alive at the memory peak come first, because their
// total size decides the size of the heap. The other items follow by their distance in time from the peak.
std::vector<uint32_t> peak_first_order(const std::vector<PackItem>& items) {
    const uint32_t peak = find_peak(items.size(), [&](size_t i) { return items[i]; }).position;
    const auto distance = [&](uint32_t i) {
        if (items[i].first > peak) return items[i].first - peak;
        return items[i].last < peak ? peak - items[i].last : 0;
    };
    std::vector<uint32_t> order = size_descending_order(items);
    std::stable_sort(order.begin(), order.end(),
                     [&](uint32_t a, uint32_t b) { return distance(a) < distance(b); });
    return order;
}

// Returns the items sorted by (size × lifetime), largest first. An item with a large product conflicts with
// many others. So it is placed early, while there is still free space.
std::vector<uint32_t> area_descending_order(const std::vector<PackItem>& items) {
    const auto area = [&](uint32_t i) {
        return items[i].size_bytes * (uint64_t{items[i].last} - items[i].first + 1);
    };
    std::vector<uint32_t> order = size_descending_order(items);
    std::stable_sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) { return area(a) > area(b); });
    return order;
}

// Improves a packing by local search. Each round moves the item with the highest end to the front of the
// order and packs all items again.
Packing search(const std::vector<PackItem>& items, std::vector<uint32_t> order, uint64_t target_bytes,
               Conflicts& conflicts) {
    Packing current = pack_in_order(items, order, conflicts), best = current;
    for (size_t round = 0; round < kMaxSearchRounds && best.height_bytes > target_bytes; ++round) {
        const auto highest = std::max_element(order.begin(), order.end(), [&](uint32_t a, uint32_t b) {
            return current.offsets_bytes[a] + items[a].size_bytes <
                   current.offsets_bytes[b] + items[b].size_bytes;
        });
        std::rotate(order.begin(), highest, highest + 1);
        current = pack_in_order(items, order, conflicts);
        if (current.height_bytes < best.height_bytes) best = current;
    }
    return best;
}

void keep_smaller(Packing packing, Packing& best) {
    if (packing.height_bytes < best.height_bytes) best = std::move(packing);
}

// An order in which items are placed, and a target: a heap that is `percent` percent above the lower bound.
struct Attempt {
    std::vector<uint32_t> (*order_of)(const std::vector<PackItem>& items);
    uint64_t percent = 0;
};
constexpr std::array kAttempts{Attempt{size_descending_order, 3}, Attempt{area_descending_order, 4},
                               Attempt{peak_first_order, 5}, Attempt{size_descending_order, 7}};

// Improves a packing until it reaches the target of an attempt, or until all attempts are made.
void improve(const std::vector<PackItem>& items, uint64_t lower_bound_bytes, Conflicts& conflicts,
             Packing& best) {
    const size_t count = items.size(), most_lowered = count <= kFewItems ? count * 2 : count / 2;
    for (const auto& [order_of, percent] : kAttempts) {
        const uint64_t target = with_percent(lower_bound_bytes, percent);
        if (best.height_bytes <= target) return;
        const std::vector<uint32_t> order = order_of(items);
        keep_smaller(pack_below(items, order, target, count, conflicts), best);
        if (best.height_bytes <= target) return;
        keep_smaller(lower(items, order, best, target, most_lowered, conflicts), best);
        if (best.height_bytes <= target) return;
        if (count <= kMaxSearchedItems) keep_smaller(search(items, order, target, conflicts), best);
    }
}

// Improves a packing for several queues. With several queues, the lifetimes of items are longer, but the
// lower bound does not take this into account. So often no packing reaches the targets, and this function
// makes fewer tries than improve().
void improve_for_queues(const std::vector<PackItem>& items, uint64_t lower_bound_bytes, Conflicts& conflicts,
                        Packing& best) {
    const size_t count = items.size();
    const bool searched = count <= kMaxSearchedItems;
    for (const auto& [order_of, percent] : std::span(kAttempts).first(searched ? 3 : 2)) {
        const uint64_t target = with_percent(lower_bound_bytes, percent);
        if (best.height_bytes <= target) return;
        const std::vector<uint32_t> order = order_of(items);
        keep_smaller(pack_below(items, order, target, searched ? count : count / 16, conflicts), best);
        if (best.height_bytes <= target) return;
        if (searched) keep_smaller(search(items, order, target, conflicts), best);
    }
}

}  // namespace

Packing pack_size_descending(const std::vector<PackItem>& items) {
    Conflicts conflicts(items);
    return pack_in_order(items, size_descending_order(items), conflicts);
}

Packing pack(const std::vector<PackItem>& items, uint64_t lower_bound_bytes, const QueueTimes* times) {
    if (items.empty()) return {};
    const bool few = items.size() <= kFewItems;
    Conflicts conflicts(items, times);
    Packing best;
    best.height_bytes = UINT64_MAX;
    const bool sweeps = conflicts.dense() || few;
    if (sweeps) keep_smaller(pack_sweep(items), best);
    if (few) keep_smaller(pack_in_order(items, size_descending_order(items), conflicts), best);
    if (sweeps) keep_smaller(pack_sweep_back(items), best);
    const bool good = best.height_bytes <= with_percent(lower_bound_bytes, kGoodSweepPercent);
    if (!few && conflicts.dense() && !good && items.size() <= kMaxDenseItems)
        keep_smaller(pack_in_order(items, size_descending_order(items), conflicts), best);
    if (conflicts.dense() && !(few && !good)) return best;
    if (times == nullptr)
        improve(items, lower_bound_bytes, conflicts, best);
    else
        improve_for_queues(items, lower_bound_bytes, conflicts, best);
    return best;
}

}  // namespace weft
