// Purpose: stores the last owner of every byte of a heap.
#pragma once

#include <cstdint>
#include <vector>

#include "weft/declaration.h"

namespace weft {

// The resource that used some bytes last, and the frame of that use.
struct Owner {
    ResourceId resource = kNoId;
    uint32_t frame = 0;
};

// A sorted list of byte ranges, each with one owner. The list is divided into short parts, so that an
// insertion moves few ranges.
class OwnerMap {
 public:
    // Appends the owners of the bytes from `begin` to `end` - 1 to `old_owners`, in the order of their bytes.
    // Then makes `owner` the owner of these bytes.
    void take(uint64_t begin, uint64_t end, Owner owner, std::vector<Owner>& old_owners);

 private:
    struct Range {
        uint64_t begin = 0;
        uint64_t end = 0;
        Owner owner;
    };
    using Part = std::vector<Range>;

    // Returns the index of the last part whose first range begins at or before `begin`, or 0 if there is
    // none.
    [[nodiscard]] size_t part_at(uint64_t begin) const;
    void divide(size_t part);

    std::vector<Part> parts_{Part{}};  // No part is empty, unless it is the only part.
};

}  // namespace weft
