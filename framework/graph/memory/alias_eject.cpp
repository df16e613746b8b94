#include "graph/memory/alias_eject.h"

#include <algorithm>
#include <span>
#include <utility>

#include "graph/memory/alias_best_fit.h"
#include "graph/model/round_up.h"

namespace weft {
namespace {

// A place below the target height for an item that fits nowhere, and the items to remove from that place.
struct Ejection {
    uint64_t offset_bytes = kNoPlace;
    std::vector<uint32_t> removed;
};

// Finds the place whose items are the cheapest to remove. The cost of an item is its size × (1 + the number
// of its earlier removals). So the cost grows, and two items cannot remove each other again and again.
class PlaceFinder {
 public:
    PlaceFinder(const std::vector<PackItem>& items, uint64_t target_bytes)
        : items_(items), target_bytes_(target_bytes) {}

    // Returns the cheapest place for the item `item`. `taken` must be sorted by offset. removals[i] is the
    // number of times that item i was removed.
    [[nodiscard]] Ejection cheapest(uint32_t item, std::span<const TakenSpan> taken,
                                    const std::vector<uint32_t>& removals) {
        add_up(taken, removals);
        best_ = kNoPlace;
        best_cost_ = UINT64_MAX;
        const PackItem& own = items_[item];
        Cursor cursor;
        offer(0, own, taken, cursor);
        for (const End& end : ends_) offer(end.bytes, own, taken, cursor);
        cursor = {};
        for (const TakenSpan& span : taken)
            if (span.begin_bytes >= own.size_bytes)
                offer(span.begin_bytes - own.size_bytes, own, taken, cursor);
        const uint64_t best = best_, size = own.size_bytes;
        Ejection ejection{best, {}};
        if (best == kNoPlace) return ejection;
        for (const TakenSpan& span : taken)
            if (span.begin_bytes < best + size && span.end_bytes > best)
                ejection.removed.push_back(span.item);
        return ejection;
    }

 private:
    // begun: number of items that begin before the end of a place.
    // ended: number of items that end at or before the begin of the place.
    struct Cursor {
        size_t begun = 0, ended = 0;
    };
    struct End {
        uint64_t bytes = 0;  // Offset of the end of an item.
        uint64_t cost = 0;   // Cost of all items that end there or before.
    };

    void add_up(std::span<const TakenSpan> taken, const std::vector<uint32_t>& removals) {
        begun_.assign(1, 0);
        ends_.clear();
        for (const TakenSpan& span : taken) {
            const uint64_t cost = items_[span.item].size_bytes * (removals[span.item] + 1);
            begun_.push_back(begun_.back() + cost);
            ends_.push_back({span.end_bytes, cost});
        }
        std::ranges::sort(ends_, {}, &End::bytes);
        uint64_t sum = 0;
        for (End& end : ends_) end.cost = sum += end.cost;
    }
    // Compares a place with the best place so far. The places must be offered in the order of their offsets.
    void offer(uint64_t begin, const PackItem& item, std::span<const TakenSpan> taken, Cursor& cursor) {
        begin = round_up(begin, item.alignment_bytes);
        const uint64_t end = begin + item.size_bytes;
        if (end > target_bytes_) return;
        while (cursor.begun < taken.size() && taken[cursor.begun].begin_bytes < end) ++cursor.begun;
        while (cursor.ended < ends_.size() && ends_[cursor.ended].bytes <= begin) ++cursor.ended;
        const uint64_t cost = begun_[cursor.begun] - (cursor.ended == 0 ? 0 : ends_[cursor.ended - 1].cost);
        if (cost >= best_cost_) return;
        best_cost_ = cost;
        best_ = begin;
    }

    const std::vector<PackItem>& items_;
    uint64_t target_bytes_;
    std::vector<uint64_t> begun_;  // begun_[n] is the total cost of the first n items in `taken`.
    std::vector<End> ends_;        // Sorted by offset.
    uint64_t best_ = kNoPlace, best_cost_ = UINT64_MAX;
};

// Places the items of `waiting`, the last one first. An item that does not fit below the target removes other
// items, which wait again. After `most_removals` removals, items are placed above the target instead.
void place(const std::vector<PackItem>& items, std::vector<uint32_t> waiting, uint64_t target_bytes,
           size_t most_removals, Conflicts& conflicts, Packing& packing) {
    // Index: item. Number of times that the item was removed.
    std::vector<uint32_t> removals(items.size(), 0);
    PlaceFinder finder(items, target_bytes);
    size_t removed = 0;
    while (!waiting.empty()) {
        const uint32_t item = waiting.back();
        waiting.pop_back();
        std::span<const TakenSpan> taken = conflicts.taken(item);
        uint64_t offset = best_fit(items[item], taken, target_bytes);
        if (offset == kNoPlace && removed < most_removals) {
            const Ejection ejection = finder.cheapest(item, taken, removals);
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
    packing.height_bytes = 0;
    for (size_t i = 0; i < items.size(); ++i)
        packing.height_bytes = std::max(packing.height_bytes, packing.offsets_bytes[i] + items[i].size_bytes);
}

}  // namespace

Packing pack_below(const std::vector<PackItem>& items, const std::vector<uint32_t>& order,
                   uint64_t target_bytes, size_t most_removals, Conflicts& conflicts) {
    Packing packing;
    packing.offsets_bytes.assign(items.size(), 0);
    conflicts.clear();
    place(items, {order.rbegin(), order.rend()}, target_bytes, most_removals, conflicts, packing);
    return packing;
}

Packing lower(const std::vector<PackItem>& items, const std::vector<uint32_t>& order, Packing packing,
              uint64_t target_bytes, size_t most_removals, Conflicts& conflicts) {
    conflicts.clear();
    std::vector<uint32_t> waiting;
    for (auto item = order.rbegin(); item != order.rend(); ++item) {
        const uint64_t offset = packing.offsets_bytes[*item];
        if (offset + items[*item].size_bytes > target_bytes)
            waiting.push_back(*item);
        else
            conflicts.place(*item, offset);
    }
    place(items, std::move(waiting), target_bytes, most_removals, conflicts, packing);
    return packing;
}

}  // namespace weft
