// Purpose: offset packing. Items that live at the same time must not share bytes.
// Units: bytes; `first` and `last` are schedule positions, both included.
// Source: size-descending best fit is the usual heuristic for offline dynamic storage allocation (Y.
// Pisarchyk, J. Lee, "Efficient Memory Management for Deep Neural Net Inference", 2020); the sweep is a
// best-fit heap run over time, near-linear where the other is not.
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
    std::vector<uint64_t> offsets_bytes;  // by item
    uint64_t height_bytes = 0;
};

// Whether two items, by index, may be in use at the same time although their positions do not overlap: on
// several queues a later position need not come later. Empty: positions say it all.
using Unordered = std::function<bool(uint32_t, uint32_t)>;

// Largest first, each into the tightest gap left by the items it lives beside.
[[nodiscard]] Packing pack_size_descending(const std::vector<PackItem>& items);
// By time: what ends gives its bytes back, what starts takes the tightest hole.
[[nodiscard]] Packing pack_sweep(const std::vector<PackItem>& items);
// The lowest of both and of a bounded search, given that nothing can be lower than `lower_bound_bytes`. The
// sweep goes by positions alone, and is left out where they do not say it all.
[[nodiscard]] Packing pack(const std::vector<PackItem>& items, uint64_t lower_bound_bytes,
                           const Unordered& unordered = {});

}  // namespace weft
