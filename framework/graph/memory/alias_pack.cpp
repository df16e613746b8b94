#include "graph/memory/alias_pack.h"

#include <algorithm>
#include <map>
#include <numeric>

#include "graph/memory/alias_conflicts.h"
#include "weft/plan.h"

namespace weft {
namespace {

// If more items than this are to be packed and most of them overlap in time, only the sweep is used: the
// best-fit orders would take too much time for the memory that they save.
constexpr size_t kMaxDenseItems = 4096;
// Limits the local search by the number of placements that it visits in all iterations together. One
// iteration packs all items once.
constexpr size_t kSearchVisits = 12'000'000;
constexpr size_t kMaxSearchRounds = 200;
// The local search stops when the heap is at most this percentage of the smallest possible size. The limit
// rises by 1 % every kRoundsPerPercent iterations, so a long search accepts a larger heap.
constexpr uint64_t kGoodEnoughPercent = 102;
constexpr size_t kRoundsPerPercent = 16;

uint64_t aligned(uint64_t offset_bytes, uint64_t alignment_bytes) {
    return (offset_bytes + alignment_bytes - 1) / alignment_bytes * alignment_bytes;
}

// Returns the offset of the smallest gap between the bytes in `taken` into which the item fits. If it fits
// into no gap, returns the offset after all taken bytes. `taken` must be sorted by offset.
uint64_t best_fit(const PackItem& item, const std::vector<ByteSpan>& taken) {
    uint64_t best = 0, best_slack = UINT64_MAX, cursor = 0;
    for (const ByteSpan& span : taken) {
        const uint64_t start = aligned(cursor, item.alignment_bytes);
        if (start + item.size_bytes <= span.begin_bytes) {
            const uint64_t slack = span.begin_bytes - cursor - item.size_bytes;
            if (slack < best_slack) {
                best_slack = slack;
                best = start;
            }
        }
        cursor = std::max(cursor, span.end_bytes);
    }
    return best_slack == UINT64_MAX ? aligned(cursor, item.alignment_bytes) : best;
}

Packing pack_in_order(const std::vector<PackItem>& items, const std::vector<uint32_t>& order,
                      Conflicts& conflicts) {
    Packing packing;
    packing.offsets_bytes.assign(items.size(), 0);
    conflicts.clear();
    for (const uint32_t i : order) {
        const uint64_t offset = best_fit(items[i], conflicts.taken(i));
        packing.offsets_bytes[i] = offset;
        packing.height_bytes = std::max(packing.height_bytes, offset + items[i].size_bytes);
        conflicts.place(i, offset);
    }
    return packing;
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

// Returns the position at which the total size of the live items is largest.
Position peak_position(const std::vector<PackItem>& items) {
    std::map<Position, int64_t> changes;
    for (const PackItem& item : items) {
        changes[Position(item.first)] += static_cast<int64_t>(item.size_bytes);
        changes[Position(item.last + 1)] -= static_cast<int64_t>(item.size_bytes);
    }
    int64_t bytes = 0, most = -1;
    Position position = 0;
    for (const auto& [at, change] : changes) {
        bytes += change;
        if (bytes <= most) continue;
        most = bytes;
        position = at;
    }
    return position;
}

// Returns an order for placing the items. Items that are alive at the memory peak come first, because their
// total size decides the size of the heap. The other items follow by their distance in time from the peak.
std::vector<uint32_t> peak_first_order(const std::vector<PackItem>& items) {
    const uint32_t peak = peak_position(items);
    const auto distance = [&](uint32_t i) {
        if (items[i].first > peak) return items[i].first - peak;
        return items[i].last < peak ? peak - items[i].last : 0;
    };
    std::vector<uint32_t> order = size_descending_order(items);
    std::stable_sort(order.begin(), order.end(),
                     [&](uint32_t a, uint32_t b) { return distance(a) < distance(b); });
    return order;
}

bool is_good_enough(const Packing& packing, uint64_t lower_bound_bytes, size_t round = 0) {
    return packing.height_bytes <= lower_bound_bytes / 100 * (kGoodEnoughPercent + round / kRoundsPerPercent);
}

// Returns the items sorted by (size × lifetime), largest first. Such items conflict with many others, so they
// are placed while there is still free space.
std::vector<uint32_t> area_descending_order(const std::vector<PackItem>& items) {
    const auto area = [&](uint32_t i) {
        return items[i].size_bytes * (uint64_t{items[i].last} - items[i].first + 1);
    };
    std::vector<uint32_t> order = size_descending_order(items);
    std::stable_sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) { return area(a) > area(b); });
    return order;
}

// Improves a packing by local search. Each iteration moves the item with the highest end to the front of the
// order and packs all items again.
Packing search(const std::vector<PackItem>& items, std::vector<uint32_t> order, Packing best,
               uint64_t lower_bound, Conflicts& conflicts) {
    const size_t rounds = std::min(kMaxSearchRounds, kSearchVisits / std::max<size_t>(conflicts.visits(), 1));
    Packing current = best;
    for (size_t round = 0; round < rounds && !is_good_enough(best, lower_bound, round); ++round) {
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

}  // namespace

Packing pack_size_descending(const std::vector<PackItem>& items) {
    Conflicts conflicts(items);
    return pack_in_order(items, size_descending_order(items), conflicts);
}

Packing pack(const std::vector<PackItem>& items, uint64_t lower_bound_bytes, const Unordered& unordered) {
    if (items.empty()) return {};
    Packing best;
    best.height_bytes = UINT64_MAX;
    if (!unordered) best = pack_sweep(items);
    if (best.height_bytes <= lower_bound_bytes) return best;
    Conflicts conflicts(items, unordered);
    if (conflicts.dense() && items.size() > kMaxDenseItems) return best;
    for (std::vector<uint32_t> order :
         {size_descending_order(items), area_descending_order(items), peak_first_order(items)}) {
        Packing packing = pack_in_order(items, order, conflicts);
        packing = search(items, std::move(order), std::move(packing), lower_bound_bytes, conflicts);
        if (packing.height_bytes < best.height_bytes) best = std::move(packing);
        if (is_good_enough(best, lower_bound_bytes)) break;
    }
    return best;
}

}  // namespace weft
