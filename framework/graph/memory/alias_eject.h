// Purpose: tries to pack items into a heap of at most a given size. An item that does not fit takes the place
// of other items, which are then placed elsewhere (ejection).
#pragma once

#include <cstdint>
#include <vector>

#include "graph/memory/alias_conflicts.h"
#include "graph/memory/alias_item.h"

namespace weft {

// Places the items in the given order, each at its best fit below `target_bytes`. An item that does not fit
// takes the place of other items, which are then placed again. After `most_removals` removals, the items that
// do not fit are placed above the target.
[[nodiscard]] Packing pack_below(const std::vector<PackItem>& items, const std::vector<uint32_t>& order,
                                 uint64_t target_bytes, size_t most_removals, Conflicts& conflicts);

// Lowers a packing that is higher than the target: the items that end above the target are placed again in
// the given order, as in pack_below(). The other items keep their places unless they are removed.
[[nodiscard]] Packing lower(const std::vector<PackItem>& items, const std::vector<uint32_t>& order,
                            Packing packing, uint64_t target_bytes, size_t most_removals,
                            Conflicts& conflicts);

}  // namespace weft
