// Purpose: finds, for an item that is to be placed, the bytes already taken by items that are alive at the
// same time. If few pairs of items are alive together (sparse), each item has a list of these items. If many
// pairs are (dense), each query scans all placed items instead, which is cheaper than to store and sort so
// many pairs.
#pragma once

#include <cstdint>
#include <vector>

#include "graph/memory/alias_pack.h"

namespace weft {

struct ByteSpan {
    uint64_t begin_bytes = 0;
    uint64_t end_bytes = 0;
};

class Conflicts {
 public:
    explicit Conflicts(const std::vector<PackItem>& items, const Unordered& unordered = {});

    void clear();
    void place(uint32_t item, uint64_t offset_bytes);
    // Returns the bytes that `item` must not use, sorted by offset. The reference is valid until the next
    // call.
    [[nodiscard]] const std::vector<ByteSpan>& taken(uint32_t item);
    [[nodiscard]] bool dense() const { return dense_; }
    // Returns the number of placements that must be visited to pack all items once. The number is an estimate
    // of the cost.
    [[nodiscard]] size_t visits() const;

 private:
    struct Placed {
        uint64_t offset_bytes = 0;
        uint32_t item = 0;
    };

    void find_neighbours();
    void find_neighbours(const Unordered& unordered);

    const std::vector<PackItem>& items_;
    bool dense_ = false;
    // Used if many items are alive together: the placed items, sorted by offset.
    std::vector<Placed> placed_;
    // Used if few items are alive together. Index: item. Its offset in bytes, or kUnplaced if the item has no
    // place yet.
    std::vector<uint64_t> offsets_bytes_;
    // Used if few items are alive together. Index: item. The items that are alive at the same time as this
    // item.
    std::vector<std::vector<uint32_t>> neighbours_;
    std::vector<ByteSpan> taken_;
};

}  // namespace weft
