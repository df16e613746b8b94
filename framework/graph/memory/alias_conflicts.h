// Purpose: for an item about to be placed, the bytes already taken by items that live at the same time.
// Sparse graphs visit only an item's neighbours in time; dense ones scan everything placed, which is cheaper
// than keeping nearly all pairs.
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
    // Sorted by offset; valid until the next call.
    [[nodiscard]] const std::vector<ByteSpan>& taken(uint32_t item);
    [[nodiscard]] bool dense() const { return dense_; }
    // How many placements one packing of all items looks at.
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
    std::vector<Placed> placed_;                     // dense: sorted by offset
    std::vector<uint64_t> offsets_bytes_;            // sparse: by item, kUnplaced until placed
    std::vector<std::vector<uint32_t>> neighbours_;  // sparse: by item
    std::vector<ByteSpan> taken_;
};

}  // namespace weft
