// Purpose: computes the history of a resource in the usual case: each access is to the whole resource, all
// accesses are on one queue, and the resource keeps nothing for the next frame. The result is that of
// track_resource(), which allows all cases, but needs several times as long.
#pragma once

#include <optional>

#include "graph/sync/track_resource.h"

namespace weft {

// Returns nullopt if the resource is another case. `events` are the accesses to `decl`, sorted by schedule
// position; there is at least one.
[[nodiscard]] std::optional<ResourceHistory> track_whole(const ResourceDecl& decl,
                                                         const std::vector<RangeAccess>& events,
                                                         const Schedule& order);

}  // namespace weft
