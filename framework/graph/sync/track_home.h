// Purpose: computes the barriers of one cell that a rest unit writes. While no pass of the unit runs, the
// cell stays in its home state: the layout that its readers need, with the content visible to all of them. So
// its readers need no barriers, whether the unit rests or runs. Each writing pass brings the cell from the
// home state to its own state and back. barriers() marks these barriers: they are recorded only in frames in
// which the pass runs.
#pragma once

#include <span>
#include <vector>

#include "graph/sync/multi_queue_tracker.h"

namespace weft {

struct HomeTrace {
    CellSync sync;
    Layout home = Layout::undefined;
};

// Returns true if a pass with a rest unit writes the resource in one of these accesses.
template <class Events>
[[nodiscard]] bool unit_writes(const ResolvedGraph& graph, const Events& events) {
    for (const auto& item : events) {
        const AccessEvent* event = nullptr;
        if constexpr (requires { item.event; })
            event = &item.event;
        else
            event = &item;
        if (event->writes && graph.passes[event->pass].rest_unit != kNoId) return true;
    }
    return false;
}

// `events` are the accesses to the cell in one frame, sorted by schedule position.
[[nodiscard]] HomeTrace track_home(const ResourceDecl& decl, ResourceId resource,
                                   std::span<const AccessEvent> events);

}  // namespace weft
