// Purpose: describes the input and the result of packing: items with a size and a lifetime, and their offsets
// in a heap. Units: bytes; `first` and `last` are schedule positions, both included.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "weft/plan.h"

namespace weft {

struct PackItem {
    uint64_t size_bytes = 0;
    uint64_t alignment_bytes = 1;
    uint32_t first = 0;
    // With several queues: from position last + 1 on, all queues are surely done with the item.
    uint32_t last = 0;
};

// The lifetimes of items for each queue. If a frame uses several queues, two items may share bytes even if
// their ranges from PackItem::first to PackItem::last overlap. It is enough that all uses of one item end
// before each queue begins to use the other item.
struct QueueTimes {
    size_t queue_count = 0;
    // Index: item × queue_count + queue. The first position on the queue that uses the item, or UINT32_MAX.
    std::vector<uint32_t> begins;
    // Index: item × queue_count + queue. The first position on the queue that surely runs after all uses of
    // the item. If there is no such position: 1 + the last position on the queue, or 0 if no pass runs on the
    // queue.
    std::vector<uint32_t> ends;

    // Returns false if all uses of item `a` surely end before item `b` begins. `a` must not begin after `b`.
    [[nodiscard]] bool may_overlap(uint32_t a, uint32_t b) const {
        for (size_t q = 0; q < queue_count; ++q)
            if (begins[b * queue_count + q] < ends[a * queue_count + q]) return true;
        return false;
    }
    // Returns the value for PackItem::last: from the next position on, all queues are surely done with the
    // item.
    [[nodiscard]] uint32_t last_position(uint32_t item) const {
        const auto first = ends.begin() + static_cast<std::ptrdiff_t>(item * queue_count);
        return *std::max_element(first, first + static_cast<std::ptrdiff_t>(queue_count)) - 1;
    }
};

struct Packing {
    std::vector<uint64_t> offsets_bytes;  // Index: item. Offset of the item in the heap.
    uint64_t height_bytes = 0;
};

struct Peak {
    uint64_t bytes = 0;
    Position position = 0;
};

// Returns the first position at which the total size of the live items is largest. `item_at(i)` returns the
// item i.
template <class ItemAt>
[[nodiscard]] Peak find_peak(size_t count, const ItemAt& item_at) {
    // Index: position. Bytes of the items that begin there, minus bytes of the items that ended just before.
    std::vector<uint64_t> changes;
    for (size_t i = 0; i < count; ++i) {
        const PackItem item = item_at(i);
        if (changes.size() < item.last + size_t{2})
            changes.resize(std::max(item.last + size_t{2}, 2 * changes.size()), 0);
        changes[item.first] += item.size_bytes;
        changes[item.last + size_t{1}] -= item.size_bytes;
    }
    Peak peak;
    uint64_t bytes = 0;
    for (size_t position = 0; position < changes.size(); ++position) {
        bytes += changes[position];
        if (bytes > peak.bytes) peak = {bytes, Position(position)};
    }
    return peak;
}

}  // namespace weft
