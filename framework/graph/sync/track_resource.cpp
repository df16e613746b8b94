#include "graph/sync/track_resource.h"

#include <algorithm>
#include <set>
#include <tuple>
#include <utility>

#include "graph/model/subresource_grid.h"
#include "graph/sync/multi_queue_tracker.h"

namespace weft {
namespace {

// Number of frames through which a persistent resource is tracked. The first frames only find the state in
// which a frame leaves the resource. After them, every frame starts and ends in the same state.
constexpr int kRoundsToSettle = 4;

// Returns all properties of a barrier except its cell. Barriers with equal keys are merged into one barrier
// for all their cells.
auto merge_key(const CellBarrier& b) {
    return std::make_tuple(b.position, b.after, b.reason, b.from, b.src.stages, b.src.access, b.src.layout,
                           b.dst.stages, b.dst.access, b.dst.layout, b.previous_frame, b.src_family,
                           b.dst_family, b.pair_position, b.pair_state.stages, b.pair_state.access);
}

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
        return std::tuple_cat(merge_key(a), std::make_tuple(a.cell)) <
               std::tuple_cat(merge_key(b), std::make_tuple(b.cell));
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

// Describes the use of a resource by queues and queue families.
struct QueueUsage {
    bool several_queues = false;
    bool several_families = false;
    // True if the resource is used by one queue family at a time. Then barriers can transfer its ownership
    // between the uses.
    bool exclusive = false;
};

using CellAccesses = std::vector<std::vector<AccessEvent>>;  // Index: cell. The accesses, by position.

// Returns false if consecutive reads in the same layout run on different queue families. Such reads may run
// at the same time, so neither family can own the resource.
bool one_family_at_a_time(const std::vector<AccessEvent>& events, const std::vector<LogicalQueue>& queues) {
    for (size_t i = 1; i < events.size(); ++i) {
        const AccessEvent &a = events[i - 1], &b = events[i];
        const bool together = !a.writes && !b.writes && a.state.layout == b.state.layout;
        if (together && queues[a.queue].family != queues[b.queue].family) return false;
    }
    return true;
}

QueueUsage queue_usage(const HistoryInput& input, const std::vector<CellAccesses>& roles) {
    std::set<QueueIndex> queues;
    std::set<uint32_t> families;
    bool in_turn = true;
    for (const CellAccesses& cells : roles) {
        for (const std::vector<AccessEvent>& events : cells) {
            for (const AccessEvent& event : events) queues.insert(event.queue);
            in_turn = in_turn && one_family_at_a_time(events, input.order->queues);
        }
    }
    for (const QueueIndex queue : queues) families.insert(input.order->queues[queue].family);
    const ResourceDecl& decl = *input.roles.front().decl;
    QueueUsage usage;
    // An import enters and leaves every frame on queue 0. The prologue, which initialises persistent
    // resources, also runs on queue 0.
    if (decl.import && !queues.empty()) queues.insert(kGraphicsQueue);
    if (decl.import) families.insert(decl.import->family);
    if (decl.lifetime == ResourceLifetime::persistent && !queues.empty())
        families.insert(input.order->queues.front().family);
    usage.several_queues = queues.size() > 1;
    usage.several_families = families.size() > 1;
    usage.exclusive = usage.several_families && in_turn && decl.kind == ResourceKind::image &&
                      decl.lifetime == ResourceLifetime::transient;
    return usage;
}

// The barriers, dependencies and final states of one cell (a block of subresources). A resource with history
// is a ring of copies, so tracking repeats the frame until the states at its end no longer change. These are
// the values of the last repetition.
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
            // The oldest copy of the ring is reused for this frame, so its content may be dropped.
            if (roles.size() > 1 && age == 0 && !events.empty()) state.discard();
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

// Returns true if the frame changes the import: it writes the import or changes its layout, or writes from
// outside the frame are pending.
bool changes(const ImportState& import, const std::vector<AccessEvent>& events) {
    const bool pending = ((import.entry.access | import.exit.access) & access::kAllWrites) != 0;
    return pending || import.entry.layout != import.exit.layout ||
           std::any_of(events.begin(), events.end(), [&](const AccessEvent& event) {
               return event.writes || event.state.layout != import.entry.layout;
           });
}

CellTrace trace_cell(const HistoryInput& input, const QueueUsage& usage, const QueueRules& rules,
                     const std::vector<CellAccesses>& roles, uint32_t cell) {
    const ResourceDecl& decl = *input.roles.front().decl;
    const auto start = decl.lifetime == ResourceLifetime::persistent ? SingleQueueTracker::Start::known
                                                                     : SingleQueueTracker::Start::taken_over;
    if (usage.several_queues)
        return run_tracker(decl.import ? MultiQueueTracker(rules, decl.import->entry,
                                                           changes(*decl.import, roles.front()[cell]))
                                       : MultiQueueTracker(rules, start),
                           roles, cell, decl);
    return run_tracker(decl.import ? SingleQueueTracker(decl.import->entry) : SingleQueueTracker(start),
                       roles, cell, decl);
}

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

// Adds the layout of each cell at the start of a frame to the resource's history. A cell that no pass uses
// keeps the layout of the prologue's clear, TRANSFER_DST.
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

SubresourceGrid grid_of(const HistoryInput& input) {
    std::vector<SubresourceRange> ranges;
    for (const Role& role : input.roles)
        for (const RangeAccess& event : role.events) ranges.push_back(event.range);
    return {*input.roles.front().decl, ranges};
}

}  // namespace

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
    const QueueUsage usage = queue_usage(input, roles);
    const QueueRules rules{input.order->queues, input.resource,
                           input.roles.front().decl->kind == ResourceKind::image, usage.exclusive,
                           Position(input.order->order.size())};
    RingHistory ring;
    ring.roles.resize(roles.size());
    ring.concurrent = usage.several_families && !usage.exclusive;
    std::vector<std::vector<CellBarrier>> barriers(roles.size());
    std::vector<std::vector<Layout>> entries(roles.size());
    for (uint32_t cell = 0; cell < grid.cell_count(); ++cell) {
        CellTrace trace = trace_cell(input, usage, rules, roles, cell);
        for (size_t age = 0; age < roles.size(); ++age) {
            for (CellBarrier& barrier : trace.sync[age].barriers) {
                barrier.cell = cell;
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
