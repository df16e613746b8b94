// Purpose: computes the vertical place of each block (a resource in a heap) on the page. Bytes are drawn to
// scale, but a block that is too small to see or to point at is drawn larger and marked as enlarged. Enlarged
// blocks that would overlap are moved apart within the heap. Units: pixels of the page, from the top of the
// heap.
#pragma once

#include <string>
#include <vector>

#include "weft/plan.h"

namespace weft {

struct ByteScale {
    uint64_t bytes = 1;  // Size of the whole heap in bytes.
    int32_t height_px = 0;

    [[nodiscard]] int32_t at(uint64_t byte) const;
};

struct ByteTick {
    int32_t y_px = 0;
    std::string text;  // Text of the tick, such as "16 MiB".
};

struct BlockPlace {
    const Placement* placement = nullptr;
    int32_t top_px = 0;
    int32_t height_px = 0;
    bool enlarged = false;  // True if the block is drawn larger than its size on the scale.
};

// Returns the scale of each heap in `heaps` (indices into MemoryPlan::heaps). All heaps have as many pixels
// per byte as the largest heap. Exception: a small heap is drawn with a minimum height.
[[nodiscard]] std::vector<ByteScale> make_byte_scales(const MemoryPlan& memory,
                                                      const std::vector<uint32_t>& heaps);
// Returns the ticks of a heap's axis: from 0 in steps of a power of two, and one at the end of the heap.
[[nodiscard]] std::vector<ByteTick> byte_ticks(const ByteScale& scale);
// Returns the blocks of the live transients in a heap. Enlarged blocks come last, so that they are drawn on
// top.
[[nodiscard]] std::vector<BlockPlace> place_blocks(const FramePlan& plan, uint32_t heap,
                                                   const ByteScale& scale);

}  // namespace weft
