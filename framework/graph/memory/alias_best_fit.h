// Purpose: finds the best gap between placed items for another item, and packs items one by one in this way.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "graph/memory/alias_conflicts.h"
#include "graph/memory/alias_item.h"

namespace weft {

// Returned by best_fit() if there is no place.
inline constexpr uint64_t kNoPlace = UINT64_MAX;
// A heap size that no packing reaches. Passed as `top_bytes` if the size of the heap is not limited.
inline constexpr uint64_t kNoLimit = UINT64_MAX / 2;

// Finds the smallest gap before or between the spans in `taken` into which the item fits, and returns the
// first aligned offset in this gap. If there is none, returns the first aligned offset after all spans.
// If the item would end above `top_bytes` there, returns kNoPlace. `taken` must be sorted by offset.
[[nodiscard]] uint64_t best_fit(const PackItem& item, std::span<const TakenSpan> taken,
                                uint64_t top_bytes);

// Places the items in the given order, each at its best fit. `order` contains indices of `items`. `conflicts`
// is cleared first.
[[nodiscard]] Packing pack_in_order(const std::vector<PackItem>& items, const std::vector<uint32_t>& order,
                                    Conflicts& conflicts);

}  // namespace weft
