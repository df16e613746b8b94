// Purpose: computes the barriers of one cell (a block of subresources) that a rest unit writes. A rest unit
// is a set of passes that run only in some frames, either all or none of them. While no pass of the unit
// runs, the cell stays in its home state: the layout that its readers need, with the content visible to all
// of them. So the readers need no barriers, whether or not the unit runs. Each writing pass brings the cell
// from the home state to the state of the write, and back. barriers() marks these barriers: they are recorded
// only in frames in which the pass runs.
#pragma once

#include <span>
#include <vector>

#include "graph/sync/multi_queue_tracker.h"

namespace weft {

struct HomeTrace {
    CellSync sync;
    Layout home = Layout::undefined;
};

// Returns true if the access is a write of a pass in a rest unit (a set of passes that run only in some
// frames).
[[nodiscard]] inline bool is_unit_write(const ResolvedGraph& graph, const AccessEvent& event) {
    return event.writes && graph.passes[event.pass].rest_unit != kNoId;
}

// `events` are the accesses to the cell in one frame, sorted by schedule position.
[[nodiscard]] HomeTrace track_home(const ResourceDecl& decl, ResourceId resource,
                                   std::span<const AccessEvent> events);

}  // namespace weft
