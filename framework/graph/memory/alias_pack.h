// Purpose: computes offsets in a heap such that items that are alive at the same time do not share bytes.
// Source: best fit in order of decreasing size is the usual heuristic for offline dynamic storage allocation
// (Y. Pisarchyk, J. Lee, "Efficient Memory Management for Deep Neural Net Inference", 2020). pack_sweep()
// simulates a best-fit heap over time. An item that fits nowhere takes the place of other items. This is
// called ejection, and is also used to search for bin packings and timetables.
#pragma once

#include <cstdint>
#include <vector>

#include "graph/memory/alias_item.h"

namespace weft {

// Places the items by decreasing size. Each item goes into the smallest sufficient gap between those placed
// items whose lifetimes overlap its own.
[[nodiscard]] Packing pack_size_descending(const std::vector<PackItem>& items);
// Places the items by the start of their lifetimes. When a lifetime ends, its bytes become a free gap; a new
// item takes the smallest sufficient gap.
[[nodiscard]] Packing pack_sweep(const std::vector<PackItem>& items);
// Like pack_sweep(), but goes backwards in time, from the last position to the first.
[[nodiscard]] Packing pack_sweep_back(std::vector<PackItem> items);
// Searches for a packing whose heap is at most a few percent larger than `lower_bound_bytes`. No packing can
// be smaller than this bound. The time is limited: it is nearly linear in the number of pairs of items whose
// lifetimes overlap. Returns the best packing found. `times` is null if the frame uses one queue.
[[nodiscard]] Packing pack(const std::vector<PackItem>& items, uint64_t lower_bound_bytes,
                           const QueueTimes* times = nullptr);

}  // namespace weft
