// Purpose: finds, for an item that is to be placed, the bytes already taken by items that are alive at the
// same time. If few pairs of items are alive together (sparse), this class stores for each item a list of the
// items that are alive with it. If many pairs are alive together (dense), each call of taken() scans all
// placed items instead. This is cheaper than to store and sort so many pairs.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "graph/memory/alias_item.h"
#include "graph/model/rows.h"

namespace weft {

// The bytes of an item that has a place.
struct TakenSpan {
    uint64_t begin_bytes = 0;
    uint64_t end_bytes = 0;
    uint32_t item = 0;
};

class Conflicts {
 public:
    // `times` is null if the frame uses one queue.
    explicit Conflicts(const std::vector<PackItem>& items, const QueueTimes* times = nullptr);

    void clear();
    void place(uint32_t item, uint64_t offset_bytes);
    void remove(uint32_t item);
    // Returns the bytes that `item` must not use, sorted by offset. The span is valid until the next call of
    // taken().
    [[nodiscard]] std::span<const TakenSpan> taken(uint32_t item);
    [[nodiscard]] bool dense() const { return dense_; }

 private:
    [[nodiscard]] bool overlap(uint32_t a, uint32_t b) const;

    const std::vector<PackItem>& items_;
    const QueueTimes* times_ = nullptr;
    bool dense_ = false;
    // Used if many items are alive together: the placed items, sorted by offset.
    std::vector<TakenSpan> placed_;
    // Index: item. Its offset in bytes, or kUnplaced if the item has no place yet.
    std::vector<uint64_t> offsets_bytes_;
    // Used if few items are alive together. Index: item. The items that are alive at the same time.
    Rows<uint32_t> neighbours_;
    std::vector<TakenSpan> taken_;
};

}  // namespace weft
