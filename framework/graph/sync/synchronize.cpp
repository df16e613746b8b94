// Computes the history (all barriers and last uses) of every resource, and the dependencies between queues
// that result from the accesses.
#include <algorithm>
#include <span>
#include <utility>

#include "graph/sync/accesses.h"
#include "graph/sync/queue_clocks.h"
#include "graph/sync/synchronize.h"
#include "graph/sync/track_home.h"
#include "graph/sync/track_whole.h"

namespace weft {
namespace {

// Returns the resources of each ring, indexed by the ring's resource of age 0 (the current frame's copy), and
// sorted by age. The rows of older copies, and of resources without a ring, are empty.
Rows<ResourceId> rings_of(const ResolvedGraph& graph) {
    Rows<ResourceId> rings = make_rows<ResourceId>(graph.resources.size(), [&](const auto& add) {
        for (ResourceId id(0); id < graph.resources.size(); ++id)
            if (graph.resources[id].ring != kNoId) add(graph.resources[id].ring, id);
    });
    std::ranges::sort(rings.items, {}, [&](ResourceId id) {
        return std::make_pair(graph.resources[id].ring, graph.resources[id].age);
    });
    return rings;
}

void add_after_edges(const ResolvedGraph& graph, const Schedule& order,
                     std::vector<QueueDependency>& dependencies) {
    for (const EdgeDecl& edge : graph.edges) {
        const Position from = order.position[edge.from], to = order.position[edge.to];
        if (edge.kind != EdgeKind::after || from == kNoId || to == kNoId) continue;
        if (order.queue[from] != order.queue[to]) dependencies.push_back({from, to, false, kNoId});
    }
}

// The program reads the resource between frames. This is like a read by a pass at the end of the frame, on
// queue 0.
RangeAccess read_by_program(const ResourceDecl& decl, const Schedule& order) {
    AccessEvent event;
    event.position = Position(order.order.size());
    event.state = *decl.between;
    event.reads = true;
    return {decl.whole(), event};
}

// Tracks the resources of one ring, or a single resource, and adds the result to the table. `retained`: track
// the resources even if no pass uses them.
void track_ring(std::span<const ResourceId> ring, bool retained, const ResolvedGraph& graph,
                const Schedule& order, const AccessTable& events, SyncTable& table) {
    HistoryInput input;
    input.graph = &graph;
    input.order = &order;
    input.resource = ring.front();
    bool touched = retained;
    for (const ResourceId id : ring) {
        input.roles.push_back({&graph.resources[id], events[id]});
        touched = touched || !events[id].empty();
    }
    if (!touched) return;
    std::vector<RangeAccess> with_program;
    if (const Role& current = input.roles.front(); current.decl->between) {
        with_program.assign(current.events.begin(), current.events.end());
        with_program.push_back(read_by_program(*current.decl, order));
        input.roles.front().events = with_program;
    }
    const RingHistory history = track_resource(input);
    for (size_t age = 0; age < ring.size(); ++age) {
        table.histories.set(ring[age], history.roles[age]);
        table.concurrent[ring[age]] = history.concurrent ? 1 : 0;
    }
    table.dependencies.insert(table.dependencies.end(), history.dependencies.begin(),
                              history.dependencies.end());
}

SyncTable with_scopes(const ResolvedGraph& graph, const LiveGraph& live, const Schedule& order,
                      const AttachmentTable& attachments, ScopeTable scopes) {
    const AccessTable events = collect_accesses(graph, order, attachments, scopes);
    const Rows<ResourceId> rings = rings_of(graph);
    WholeTracker whole(order);
    SyncTable table;
    table.scopes = std::move(scopes);
    table.histories = HistoryTable(graph.resources.size());
    table.histories.reserve(events.items.size());
    table.concurrent.assign(graph.resources.size(), 0);
    for (ResourceId id(0); id < graph.resources.size(); ++id) {
        const ResourceDecl& resource = graph.resources[id];
        if (resource.ring != kNoId) {
            if (!rings[id].empty())
                track_ring(rings[id], live.retained[id] != 0, graph, order, events, table);
            continue;
        }
        if (events[id].empty()) continue;
        const bool has_home =
            graph.rest_unit_count > 0 && std::ranges::any_of(events[id], [&](const RangeAccess& access) {
                return is_unit_write(graph, access.event);
            });
        const WholeHistory* found = has_home ? nullptr : whole.track(id, resource, events[id]);
        if (found == nullptr) {
            track_ring({&id, 1}, false, graph, order, events, table);
            continue;
        }
        table.histories.set(id, found->history);
        table.concurrent[id] = found->concurrent ? 1 : 0;
        table.dependencies.insert(table.dependencies.end(), found->dependencies.begin(),
                                  found->dependencies.end());
    }
    add_after_edges(graph, order, table.dependencies);
    return table;
}

}  // namespace

SyncTable synchronize(const ResolvedGraph& graph, const LiveGraph& live, const Schedule& order,
                      const AttachmentTable& attachments, ScopeTable candidates) {
    for (;;) {
        SyncTable table = with_scopes(graph, live, order, attachments, candidates);
        candidates = undivided(table.scopes, table.histories.barriers());
        // If a barrier must be recorded inside a rendering scope, undivided() divides the scope, and all
        // barriers are computed again. Only the pass that then begins its own scope needs more barriers than
        // before.
        if (candidates == table.scopes) return table;
    }
}

Schedule add_clocks(Schedule order, const std::vector<QueueDependency>& dependencies) {
    order.clocks = frame_clocks(order.queue, order.queues.size(), dependencies);
    return order;
}

}  // namespace weft
