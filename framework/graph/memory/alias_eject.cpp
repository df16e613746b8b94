#include "graph/memory/alias_eject.h"

#include <algorithm>

#include "graph/memory/alias_best_fit.h"
#include "graph/model/round_up.h"

namespace weft {
namespace {

// A place below the target height for an item that fits nowhere, and the items to remove from that place.
struct Ejection {
    uint64_t offset_bytes = kNoPlace;
    std::vector<uint32_t> removed;
};

// Returns the place that removes the least. An item costs its size, multiplied by the number of times that
// it was removed before plus one, so that no two items remove each other for ever.
Ejection cheapest_place(const std::vector<PackItem>& items, uint32_t item,
                        const std::vector<TakenSpan>& taken, const std::vector<uint32_t>& removals,
                        uint64_t target_bytes) {
    const uint64_t size = items[item].size_bytes;
    uint64_t best = kNoPlace;
    uint64_t best_cost = UINT64_MAX;
    const auto offer = [&](uint64_t begin) {
        begin = round_up(begin, items[item].alignment_bytes);
        if (begin + size > target_bytes) return;
        uint64_t cost = 0;
        for (const TakenSpan& span : taken) {
            if (span.begin_bytes >= begin + size) break;
            if (span.end_bytes <= begin) continue;
            cost += items[span.item].size_bytes * (removals[span.item] + 1);
            if (cost >= best_cost) return;
        }
        best_cost = cost;
        best = begin;
    };
    offer(0);
    for (const TakenSpan& span : taken) {
        offer(span.end_bytes);
        if (span.begin_bytes >= size) offer(span.begin_bytes - size);
    }
    Ejection ejection{best, {}};
    if (best == kNoPlace) return ejection;
    for (const TakenSpan& span : taken)
        if (span.begin_bytes < best + size && span.end_bytes > best) ejection.removed.push_back(span.item);
    return ejection;
}

}  // namespace

Packing pack_below(const std::vector<PackItem>& items, const std::vector<uint32_t>& order,
                   uint64_t target_bytes, Conflicts& conflicts) {
    Packing packing;
    packing.offsets_bytes.assign(items.size(), 0);
    conflicts.clear();
    std::vector<uint32_t> waiting(order.rbegin(), order.rend());
    // Index: item. Number of times that the item was removed.
    std::vector<uint32_t> removals(items.size(), 0);
    size_t removed = 0;
    while (!waiting.empty()) {
        const uint32_t item = waiting.back();
        waiting.pop_back();
        const std::vector<TakenSpan>& taken = conflicts.taken(item);
        uint64_t offset = best_fit(items[item], taken, target_bytes);
        if (offset == kNoPlace && removed < items.size()) {
            const Ejection ejection = cheapest_place(items, item, taken, removals, target_bytes);
            offset = ejection.offset_bytes;
            removed += ejection.removed.size();
            for (const uint32_t other : ejection.removed) {
                conflicts.remove(other);
                ++removals[other];
                waiting.push_back(other);
            }
        }
        if (offset == kNoPlace) offset = best_fit(items[item], conflicts.taken(item), kNoLimit);
        packing.offsets_bytes[item] = offset;
        conflicts.place(item, offset);
    }
    for (size_t i = 0; i < items.size(); ++i)
        packing.height_bytes = std::max(packing.height_bytes, packing.offsets_bytes[i] + items[i].size_bytes);
    return packing;
}

}  // namespace weft
