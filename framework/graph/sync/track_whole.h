// Purpose: computes the history of a resource in the usual case: each access is to the whole resource, all
// accesses are on one queue, and the resource keeps nothing for the next frame. The result is that of
// track_resource(), which allows all cases, but needs several times as long.
#pragma once

#include "graph/sync/track_resource.h"

namespace weft {

class WholeTracker {
 public:
    explicit WholeTracker(const Schedule& order) : order_(order) {}

    // Returns the history, which is valid until the next call; nullptr if the resource is another case.
    // `events` are the accesses to `decl`, sorted by schedule position; there is at least one.
    [[nodiscard]] const ResourceHistory* track(const ResourceDecl& decl, std::span<const RangeAccess> events);

 private:
    const Schedule& order_;
    // Memory for one call. It is kept, so that further calls need no allocations.
    std::vector<AccessEvent> merged_;
    CellSync sync_;
    ResourceHistory history_;
};

}  // namespace weft
