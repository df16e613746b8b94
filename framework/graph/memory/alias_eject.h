// Purpose: packs items into a heap of at most a given size. An item that does not fit takes the place of
// other items, which are then placed elsewhere (ejection).
#pragma once

#include <cstdint>
#include <vector>

#include "graph/memory/alias_conflicts.h"
#include "graph/memory/alias_pack.h"

namespace weft {

// Returned by best_fit() if there is no place.
inline constexpr uint64_t kNowhere = UINT64_MAX;

// Returns the offset of the smallest gap between the bytes in `taken` into which the item fits. If there is
// none, returns the offset after all taken bytes if the item ends at or below `top_bytes` there, else
// kNowhere. `taken` must be sorted by offset.
[[nodiscard]] uint64_t best_fit(const PackItem& item, const std::vector<TakenSpan>& taken,
                                uint64_t top_bytes);

// Places the items in the given order, each at its best fit.
[[nodiscard]] Packing pack_in_order(const std::vector<PackItem>& items, const std::vector<uint32_t>& order,
                                    Conflicts& conflicts);

// Places the items in the given order, each at its best fit below `target_bytes`. An item that does not fit
// takes the place of other items, which are then placed again. After as many removals as there are items, the
// remaining items are placed above the target.
[[nodiscard]] Packing pack_below(const std::vector<PackItem>& items, const std::vector<uint32_t>& order,
                                 uint64_t target_bytes, Conflicts& conflicts);

}  // namespace weft
