#include "graph/memory/alias_pack.h"

#include <algorithm>
#include <map>
#include <numeric>

#include "graph/memory/alias_conflicts.h"

namespace weft {
namespace {

// Past this many items that mostly overlap, best fit by size costs more than it saves.
constexpr size_t kMaxDenseItems = 4096;
// The bounded search looks at this many neighbours in all; one round looks at as many as one packing.
constexpr size_t kSearchVisits = 12'000'000;
constexpr size_t kMaxSearchRounds = 200;
// Nearer than this to the least possible, a search is not worth its time; the longer it takes, the less it
// asks for.
constexpr uint64_t kGoodEnoughPercent = 102;
constexpr size_t kRoundsPerPercent = 16;

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

// The position at which the items in use are largest together.
uint32_t peak_position(const std::vector<PackItem>& items) {
    std::map<uint32_t, int64_t> changes;
    for (const PackItem& item : items) {
        changes[item.first] += static_cast<int64_t>(item.size_bytes);
        changes[item.last + 1] -= static_cast<int64_t>(item.size_bytes);
    }
    int64_t bytes = 0, most = -1;
    uint32_t position = 0;
    for (const auto& [at, change] : changes) {
        bytes += change;
        if (bytes <= most) continue;
        most = bytes;
        position = at;
    }
    return position;
}

// Items that live at the peak have no room to spare and are placed first. The others follow by their distance
// from it.
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

// Large and long-lived first: what is in many items' way finds its place before them.
std::vector<uint32_t> area_descending_order(const std::vector<PackItem>& items) {
    const auto area = [&](uint32_t i) {
        return items[i].size_bytes * (uint64_t{items[i].last} - items[i].first + 1);
    };
    std::vector<uint32_t> order = size_descending_order(items);
    std::stable_sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) { return area(a) > area(b); });
    return order;
}

// The item that reached the top is placed first in the next round.
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
