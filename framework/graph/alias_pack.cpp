#include "graph/alias_pack.h"

#include <algorithm>
#include <numeric>

#include "graph/alias_conflicts.h"

namespace weft {
namespace {

// Past this many items that mostly overlap, best fit by size costs more than it saves.
constexpr size_t kMaxDenseItems = 4096;
// Graphs up to this size also get the bounded search; one round costs as much as one packing.
constexpr size_t kMaxSearchItems = 384;
constexpr int kSearchRounds = 32;

uint64_t aligned(uint64_t offset_bytes, uint64_t alignment_bytes) {
    return (offset_bytes + alignment_bytes - 1) / alignment_bytes * alignment_bytes;
}

// `taken` is sorted by offset. The tightest gap that holds the item, else the top.
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

// Whatever reached the top gets first choice in the next round.
Packing search(const std::vector<PackItem>& items, std::vector<uint32_t> order, Packing best,
               uint64_t lower_bound, Conflicts& conflicts) {
    Packing current = best;
    for (int round = 0; round < kSearchRounds && best.height_bytes > lower_bound; ++round) {
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
    Packing best;
    best.height_bytes = UINT64_MAX;
    if (!unordered) best = pack_sweep(items);
    if (best.height_bytes <= lower_bound_bytes) return best;
    Conflicts conflicts(items, unordered);
    if (conflicts.dense() && items.size() > kMaxDenseItems) return best;
    const std::vector<uint32_t> order = size_descending_order(items);
    Packing by_size = pack_in_order(items, order, conflicts);
    if (items.size() <= kMaxSearchItems)
        by_size = search(items, order, std::move(by_size), lower_bound_bytes, conflicts);
    return by_size.height_bytes < best.height_bytes ? by_size : best;
}

}  // namespace weft
