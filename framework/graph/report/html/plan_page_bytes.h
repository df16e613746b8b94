// Purpose: where the blocks of a heap stand on the page: bytes are to scale. A block too small to be seen or
// pointed at is drawn larger, and says so; those that it would hide among its like move on, down to the
// heap's end at most. Units: pixels of the page, from the heap's top.
#pragma once

#include <string>
#include <vector>

#include "weft/plan.h"

namespace weft {

struct ByteScale {
    uint64_t bytes = 1;  // of the whole heap
    int32_t height_px = 0;

    [[nodiscard]] int32_t at(uint64_t byte) const;
};

struct ByteTick {
    int32_t y_px = 0;
    std::string text;  // all of an axis in one unit
};

struct BlockPlace {
    const Placement* placement = nullptr;
    int32_t top_px = 0;
    int32_t height_px = 0;
    bool enlarged = false;  // higher than to scale
};

// All heaps have the scale of the largest one of `heaps`, but for those that would be too low.
[[nodiscard]] std::vector<ByteScale> make_byte_scales(const MemoryPlan& memory,
                                                      const std::vector<uint32_t>& heaps);
// From 0 by a power of two, and the heap's end.
[[nodiscard]] std::vector<ByteTick> byte_ticks(const ByteScale& scale);
// Those that live, as the plan has them; enlarged ones come last, to lie on top.
[[nodiscard]] std::vector<BlockPlace> place_blocks(const FramePlan& plan, uint32_t heap,
                                                   const ByteScale& scale);

}  // namespace weft
