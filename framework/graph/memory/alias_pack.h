// Purpose: computes offsets in a heap such that items that are alive at the same time do not share bytes.
// Units: bytes; `first` and `last` are schedule positions, both included.
// Source: best fit in order of decreasing size is the usual heuristic for offline dynamic storage allocation
// (Y. Pisarchyk, J. Lee, "Efficient Memory Management for Deep Neural Net Inference", 2020). pack_sweep()
// simulates a best-fit heap over time. Items that fit nowhere take the place of others: an ejection, as in
// the search for bin packings and timetables.
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
// Does the same backwards in time, from the last position to the first.
[[nodiscard]] Packing pack_sweep_back(std::vector<PackItem> items);
// A height that no packing reaches.
inline constexpr uint64_t kNoTop = UINT64_MAX / 2;
// Returns a packing whose heap is a few percent larger than `lower_bound_bytes` at most, if it finds one in a
// time that is nearly linear in the number of overlapping lifetimes. No packing can be smaller than the lower
// bound. The sweeps use positions only, so they are skipped if `unordered` is given.
[[nodiscard]] Packing pack(const std::vector<PackItem>& items, uint64_t lower_bound_bytes,
                           const Unordered& unordered = {});

}  // namespace weft
