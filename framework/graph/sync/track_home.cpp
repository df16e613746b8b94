#include "graph/sync/track_home.h"

#include <algorithm>

namespace weft {
namespace {

// Returns the union of the stages and accesses of the readers, or of the writers, on one queue.
AccessState united(std::span<const AccessEvent> events, QueueIndex queue, bool writers) {
    AccessState state;
    for (const AccessEvent& event : events) {
        if (event.queue != queue || event.writes != writers) continue;
        state.stages |= event.state.stages;
        state.access |= event.state.access;
    }
    return state;
}

// All readers need the same layout: resolve() has ensured this. Without readers, the cell stays in the
// layout of its last writer.
Layout home_layout(std::span<const AccessEvent> events) {
    const auto reader = std::ranges::find(events, false, &AccessEvent::writes);
    return reader == events.end() ? events.back().state.layout : reader->state.layout;
}

// Adds the dependencies between a writer and all accesses on other queues. An earlier access in the frame
// waits for the writer of the previous frame, and the writer waits for that access. A later access waits for
// the writer, and the writer of the next frame waits for that access.
void add_dependencies(const AccessEvent& writer, std::span<const AccessEvent> events, ResourceId resource,
                      CellSync& sync) {
    for (const AccessEvent& other : events) {
        if (other.queue == writer.queue) continue;
        const bool later = other.position > writer.position;
        sync.dependencies.push_back({writer.position, other.position, !later, resource});
        sync.dependencies.push_back({other.position, writer.position, later, resource});
    }
}

}  // namespace

HomeTrace track_home(const ResourceDecl& decl, ResourceId resource, std::span<const AccessEvent> events) {
    HomeTrace trace{.sync = {}, .home = home_layout(events)};
    const bool alone = std::ranges::all_of(events, &AccessEvent::writes);
    for (const AccessEvent& event : events) {
        if (!event.writes) continue;
        const AccessState readers = united(events, event.queue, false);
        const AccessState writers = united(events, event.queue, true);
        const bool elsewhere =
            std::ranges::any_of(events, [&](const AccessEvent& other) { return other.queue != event.queue; });
        const bool returns = !alone || event.state.layout != trace.home;
        // If no reader is on this queue, the barrier after the pass has the stages of the writers as its
        // destination. Then the barrier before the next write waits for it, because that barrier has the same
        // stages as its source.
        const StageMask home_stages = readers.stages != stage::kNone ? readers.stages : writers.stages;
        AccessState src{home_stages, returns ? access::kNone : writers.access & access::kAllWrites,
                        trace.home};
        // A transient has no content before its first write. With this write, it takes its memory over from
        // its own use in the previous frame.
        const bool begins = !event.reads && decl.lifetime == ResourceLifetime::transient;
        if (begins) src.layout = Layout::undefined;
        // If other queues access the cell, the pass waits for semaphores. The barrier includes the stages
        // that wait, so that it runs after the semaphore waits.
        if (elsewhere) src.stages |= event.state.stages;
        trace.sync.barriers.push_back({.position = event.position,
                                       .src = src,
                                       .dst = event.state,
                                       .reason = begins  ? BarrierReason::alias
                                                 : alone ? BarrierReason::waw
                                                         : BarrierReason::war,
                                       .previous_frame = true});
        add_dependencies(event, events, resource, trace.sync);
        if (!returns) continue;
        const AccessState dst{home_stages, readers.access, trace.home};
        trace.sync.barriers.push_back(
            {.position = event.position,
             .after = true,
             .src = {event.state.stages, event.state.access & access::kAllWrites, event.state.layout},
             .dst = dst,
             .reason = BarrierReason::raw,
             .from = event.pass});
    }
    return trace;
}

}  // namespace weft
