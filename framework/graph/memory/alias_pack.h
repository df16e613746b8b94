// Purpose: computes offsets in a heap such that items that are alive at the same time do not share bytes.
// Units: bytes; `first` and `last` are schedule positions, both included.
// Source: best fit in order of decreasing size is the usual heuristic for offline dynamic storage allocation
// (Y. Pisarchyk, J. Lee, "Efficient Memory Management for Deep Neural Net Inference", 2020). pack_sweep()
// simulates a best-fit heap over time; its run time is nearly linear, where the other heuristic's is
// quadratic.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

namespace weft {

struct PackItem {
    uint64_t size_bytes = 0;
    uint64_t alignment_bytes = 1;
    uint32_t first = 0;
    uint32_t last = 0;
};

struct Packing {
    std::vector<uint64_t> offsets_bytes;  // Index: item. Offset of the item in the heap.
    uint64_t height_bytes = 0;
};

// A function that returns true if two items (given by their indices) may be in use at the same time although
// their positions do not overlap. This happens with several queues, because a pass at a later position may
// run earlier on another queue. An empty function means that positions alone decide.
using Unordered = std::function<bool(uint32_t, uint32_t)>;

// Places the items by decreasing size, each into the smallest sufficient gap between items that are alive at
// the same time.
[[nodiscard]] Packing pack_size_descending(const std::vector<PackItem>& items);
// Places the items by the start of their lifetimes. When a lifetime ends, its bytes become a free gap; a new
// item takes the smallest sufficient gap.
[[nodiscard]] Packing pack_sweep(const std::vector<PackItem>& items);
// Returns the packing with the smallest heap size that the sweep, the best-fit orders and a bounded local
// search find. No packing can be smaller than `lower_bound_bytes`, so the search stops near it. The sweep
// uses positions only, so it is skipped if `unordered` is given.
[[nodiscard]] Packing pack(const std::vector<PackItem>& items, uint64_t lower_bound_bytes,
                           const Unordered& unordered = {});

}  // namespace weft
