#include "graph/sync/track_resource.h"

#include <algorithm>
#include <set>
#include <tuple>
#include <utility>

#include "graph/model/subresource_grid.h"
#include "graph/sync/multi_queue_tracker.h"
#include "graph/sync/queue_usage.h"
#include "graph/sync/track_home.h"

namespace weft {
namespace {

// Number of rounds in which a persistent resource is tracked. In a round, a copy of the ring passes through
// all ages, one frame for each age. The first rounds only find the state in which a round leaves the copy.
// After them, every round starts and ends in the same state.
constexpr int kRoundsToSettle = 4;

// Returns the accesses to each cell, indexed by cell.
std::vector<std::vector<AccessEvent>> events_by_cell(const SubresourceGrid& grid,
                                                     std::span<const RangeAccess> events) {
    std::vector<std::vector<AccessEvent>> cells(grid.cell_count());
    for (const RangeAccess& t : events) {
        for (const uint32_t cell : grid.cells_of(t.range)) append_access(t.event, cells[cell]);
    }
    return cells;
}

std::vector<PlacedBarrier> merge_cells(const SubresourceGrid& grid, std::vector<CellBarrier> barriers) {
    std::sort(barriers.begin(), barriers.end(), [](const CellBarrier& a, const CellBarrier& b) {
        return std::make_tuple(merge_key(a), a.cell) < std::make_tuple(merge_key(b), b.cell);
    });
    std::vector<PlacedBarrier> result;
    for (size_t i = 0; i < barriers.size();) {
        const CellBarrier& barrier = barriers[i];
        std::vector<uint32_t> cells;
        for (; i < barriers.size() && merge_key(barriers[i]) == merge_key(barrier); ++i)
            cells.push_back(barriers[i].cell);
        for (const SubresourceRange& range : grid.merge(cells))
            result.push_back(placed_barrier(barrier, range));
    }
    return result;
}

using CellAccesses = std::vector<std::vector<AccessEvent>>;  // Index: cell. Rows sorted by position.

QueueUsage queue_usage(const HistoryInput& input, const std::vector<CellAccesses>& roles) {
    std::vector<std::span<const AccessEvent>> all;
    for (const CellAccesses& cells : roles) all.insert(all.end(), cells.begin(), cells.end());
    return weft::queue_usage(*input.roles.front().decl, *input.order, all);
}

// The result of tracking one cell (a block of subresources). A persistent resource is tracked in
// kRoundsToSettle rounds; after that many rounds, its state at the end of a round no longer changes. The
// members have the values of the last round.
struct CellTrace {
    std::vector<CellSync> sync;  // Index: age in the ring. Barriers and dependencies of the cell.
    std::vector<Layout> entry;   // Index: age in the ring. Layout at the start of the frame.
    std::vector<std::vector<LastUse>> last_uses;  // Index: age in the ring. Last uses on each queue.
};

template <class State>
CellTrace run_tracker(State state, const std::vector<CellAccesses>& roles, uint32_t cell,
                      const ResourceDecl& decl) {
    const bool persistent = decl.lifetime == ResourceLifetime::persistent;
    CellTrace trace;
    for (int round = 0; round < (persistent ? kRoundsToSettle : 1); ++round) {
        trace = {};
        for (size_t age = 0; age < roles.size(); ++age) {
            const std::span<const AccessEvent> events(roles[age][cell]);
            if (persistent) state.next_frame();
            trace.entry.push_back(state.layout());
            // The oldest copy of the ring is reused for this frame. If a pass uses this copy, its old content
            // is not needed. If only the program uses the copy, the program reads the content, which
            // must stay.
            if (roles.size() > 1 && age == 0 && !events.empty() && events.front().pass != kNoId)
                state.discard();
            CellSync sync;
            for (size_t i = 0; i < events.size(); ++i) state.advance(events.subspan(i), sync);
            if (decl.import) state.release(decl.import->exit, sync);
            trace.sync.push_back(std::move(sync));
            trace.last_uses.emplace_back();
            state.add_last_uses(trace.last_uses.back());
        }
    }
    return trace;
}

// Returns true if one of these accesses is a write of a rest unit (a set of passes that run only in some
// frames).
bool has_home(const HistoryInput& input, std::span<const AccessEvent> events) {
    return input.graph->rest_unit_count > 0 && std::ranges::any_of(events, [&](const AccessEvent& event) {
               return is_unit_write(*input.graph, event);
           });
}

// Traces a cell that a rest unit (a set of passes that run only in some frames) writes. At the start of each
// frame, such a cell is in its home state: the layout that its readers need.
CellTrace trace_home(const HistoryInput& input, std::span<const AccessEvent> events) {
    HomeTrace home = track_home(*input.roles.front().decl, input.resource, events);
    CellTrace trace;
    trace.sync.push_back(std::move(home.sync));
    trace.entry.push_back(home.home);
    trace.last_uses.emplace_back();
    for (const AccessEvent& event : events)
        trace.last_uses.front().push_back(
            {event.queue, event.position, event.state.stages, access::kNone, event.pass});
    return trace;
}

CellTrace trace_cell(const HistoryInput& input, const QueueUsage& usage, const QueueRules& rules,
                     const std::vector<CellAccesses>& roles, uint32_t cell) {
    const ResourceDecl& decl = *input.roles.front().decl;
    if (has_home(input, roles.front()[cell])) return trace_home(input, roles.front()[cell]);
    const auto start = decl.lifetime == ResourceLifetime::persistent ? SingleQueueTracker::Start::known
                                                                     : SingleQueueTracker::Start::taken_over;
    if (usage.several_queues)
        return run_tracker(decl.import ? MultiQueueTracker(rules, decl.import->entry,
                                                           changes_import(*decl.import, roles.front()[cell]))
                                       : MultiQueueTracker(rules, start),
                           roles, cell, decl);
    return run_tracker(decl.import ? SingleQueueTracker(decl.import->entry) : SingleQueueTracker(start),
                       roles, cell, decl);
}

// Adds the layout of each cell at the start of a frame to the resource's history. A cell that no pass uses
// stays in TRANSFER_DST, the layout in which the prologue cleared it.
void add_entry(const SubresourceGrid& grid, ResourceKind kind, std::vector<Layout> layouts,
               ResourceHistory& history) {
    if (kind == ResourceKind::image)
        std::replace(layouts.begin(), layouts.end(), Layout::undefined, Layout::transfer_dst);
    for (const Layout layout : std::set<Layout>(layouts.begin(), layouts.end())) {
        std::vector<uint32_t> cells;
        for (uint32_t cell = 0; cell < layouts.size(); ++cell)
            if (layouts[cell] == layout) cells.push_back(cell);
        for (const SubresourceRange& range : grid.merge(cells))
            history.entry.push_back({kNoId, range, {stage::kNone, access::kNone, layout}, 0});
    }
}

// `barrier` is the barrier before the read that the program makes between frames. Moves the barrier to the
// end of the frame.
void leave_to_program(CellBarrier& barrier) {
    barrier.position = kEpiloguePosition;
    barrier.reason = BarrierReason::release_import;
}

SubresourceGrid grid_of(const HistoryInput& input) {
    std::vector<SubresourceRange> ranges;
    for (const Role& role : input.roles)
        for (const RangeAccess& event : role.events) ranges.push_back(event.range);
    return {*input.roles.front().decl, ranges};
}

}  // namespace

// Merges the last uses of one cell into the last uses of the whole resource. For each queue only the latest
// position is kept, because a semaphore wait for it also covers earlier positions.
void add_last_uses(const std::vector<LastUse>& cell, std::vector<LastUse>& all) {
    for (const LastUse& use : cell) {
        const auto same = std::find_if(all.begin(), all.end(),
                                       [&](const LastUse& other) { return other.queue == use.queue; });
        if (same == all.end()) {
            all.push_back(use);
            continue;
        }
        same->position = std::max(same->position, use.position);
        same->stages |= use.stages;
        same->writes |= use.writes;
        if (same->pass != use.pass) same->pass = kNoId;
    }
}

PlacedBarrier placed_barrier(const CellBarrier& barrier, const SubresourceRange& range) {
    return {barrier.position,
            barrier.after,
            {.range = range,
             .src = barrier.src,
             .dst = barrier.dst,
             .src_family = barrier.src_family,
             .dst_family = barrier.dst_family,
             .reason = barrier.reason,
             .from = barrier.from,
             .from_previous_frame = barrier.previous_frame}};
}

RingHistory track_resource(const HistoryInput& input) {
    const SubresourceGrid grid = grid_of(input);
    std::vector<CellAccesses> roles;
    for (const Role& role : input.roles) roles.push_back(events_by_cell(grid, role.events));
    QueueUsage usage = queue_usage(input, roles);
    // A transfer of ownership needs both passes in one frame: the pass that releases and the pass that
    // acquires. But passes of a rest unit run only in some frames, so there are no ownership transfers here.
    if (std::ranges::any_of(roles.front(), [&](const auto& events) { return has_home(input, events); }))
        usage.exclusive = false;
    const QueueRules rules{input.order->queues, input.resource,
                           input.roles.front().decl->kind == ResourceKind::image, usage.exclusive,
                           Position(input.order->order.size())};
    RingHistory ring;
    ring.roles.resize(roles.size());
    ring.concurrent = usage.concurrent();
    std::vector<std::vector<CellBarrier>> barriers(roles.size());
    std::vector<std::vector<Layout>> entries(roles.size());
    for (uint32_t cell = 0; cell < grid.cell_count(); ++cell) {
        CellTrace trace = trace_cell(input, usage, rules, roles, cell);
        for (size_t age = 0; age < roles.size(); ++age) {
            for (CellBarrier& barrier : trace.sync[age].barriers) {
                barrier.cell = cell;
                if (barrier.position == rules.epilogue) leave_to_program(barrier);
                barriers[age].push_back(barrier);
            }
            entries[age].push_back(trace.entry[age]);
            add_last_uses(trace.last_uses[age], ring.roles[age].last_uses);
            ring.dependencies.insert(ring.dependencies.end(), trace.sync[age].dependencies.begin(),
                                     trace.sync[age].dependencies.end());
        }
    }
    const bool persistent = input.roles.front().decl->lifetime == ResourceLifetime::persistent;
    for (size_t age = 0; age < roles.size(); ++age) {
        ring.roles[age].barriers = merge_cells(grid, std::move(barriers[age]));
        if (persistent)
            add_entry(grid, input.roles.front().decl->kind, std::move(entries[age]), ring.roles[age]);
    }
    return ring;
}

}  // namespace weft
