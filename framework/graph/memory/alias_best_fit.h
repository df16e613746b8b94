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
// A size of a heap that no packing reaches.
inline constexpr uint64_t kNoLimit = UINT64_MAX / 2;

// Returns the offset of the smallest gap between the bytes in `taken` into which the item fits. If there is
// none, returns the offset after all taken bytes if the item ends at or below `top_bytes` there, else
// kNoPlace. `taken` must be sorted by offset.
[[nodiscard]] uint64_t best_fit(const PackItem& item, std::span<const TakenSpan> taken,
                                uint64_t top_bytes);

// Places the items in the given order, each at its best fit.
[[nodiscard]] Packing pack_in_order(const std::vector<PackItem>& items, const std::vector<uint32_t>& order,
                                    Conflicts& conflicts);

}  // namespace weft
