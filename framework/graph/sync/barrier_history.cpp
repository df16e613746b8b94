#include "graph/sync/barrier_history.h"

#include <algorithm>
#include <set>
#include <tuple>
#include <utility>

#include "graph/model/subresource_grid.h"
#include "graph/sync/barrier_queues.h"

namespace weft {
namespace {

// A frame leaves a persistent resource as it found it once it has been walked a few times: the first rounds
// only find out in which state that is.
constexpr int kRoundsToSettle = 4;

// Everything but the cell: barriers with equal keys become one over the union of their cells.
auto fate(const CellBarrier& b) {
    return std::make_tuple(b.position, b.after, b.reason, b.from, b.src.stages, b.src.access, b.src.layout,
                           b.dst.stages, b.dst.access, b.dst.layout, b.previous_frame, b.src_family,
                           b.dst_family, b.pair_position, b.pair_state.stages, b.pair_state.access);
}

// By cell. Several ports of one pass on one cell become one touch; resolve() saw to it that their layouts
// agree.
std::vector<std::vector<Touch>> touches_by_cell(const SubresourceGrid& grid,
                                                const std::vector<RangeTouch>& touches) {
    std::vector<std::vector<Touch>> cells(grid.cell_count());
    for (const RangeTouch& t : touches) {
        for (const uint32_t cell : grid.cells_of(t.range)) {
            std::vector<Touch>& history = cells[cell];
            if (history.empty() || history.back().position != t.touch.position) {
                history.push_back(t.touch);
                continue;
            }
            Touch& same = history.back();
            same.state.stages |= t.touch.state.stages;
            same.state.access |= t.touch.state.access;
            same.writes = same.writes || t.touch.writes;
            same.reads = same.reads || t.touch.reads;
            if (t.touch.continues != same.continues) same.continues = kNoId;
        }
    }
    return cells;
}

std::vector<PlacedBarrier> merged(const SubresourceGrid& grid, std::vector<CellBarrier> barriers) {
    std::sort(barriers.begin(), barriers.end(), [](const CellBarrier& a, const CellBarrier& b) {
        return std::tuple_cat(fate(a), std::make_tuple(a.cell)) <
               std::tuple_cat(fate(b), std::make_tuple(b.cell));
    });
    std::vector<PlacedBarrier> result;
    for (size_t i = 0; i < barriers.size();) {
        const CellBarrier& barrier = barriers[i];
        std::vector<uint32_t> cells;
        for (; i < barriers.size() && fate(barriers[i]) == fate(barrier); ++i)
            cells.push_back(barriers[i].cell);
        for (const SubresourceRange& range : grid.merged(cells)) {
            BarrierDecl decl;
            decl.range = range;
            decl.src = barrier.src;
            decl.dst = barrier.dst;
            decl.src_family = barrier.src_family;
            decl.dst_family = barrier.dst_family;
            decl.reason = barrier.reason;
            decl.from = barrier.from;
            decl.from_previous_frame = barrier.previous_frame;
            result.push_back({barrier.position, barrier.after, decl});
        }
    }
    return result;
}

// Which queues and families touch a resource, and in what way.
struct QueueUsage {
    bool several_queues = false;
    bool several_families = false;
    bool exclusive = false;  // one family at a time, in an order that the touches themselves give
};

using CellTouches = std::vector<std::vector<Touch>>;  // by cell

// Reads that share a layout run side by side: then no family can own them.
bool one_family_at_a_time(const std::vector<Touch>& touches, const std::vector<LogicalQueue>& queues) {
    for (size_t i = 1; i < touches.size(); ++i) {
        const Touch &a = touches[i - 1], &b = touches[i];
        const bool together = !a.writes && !b.writes && a.state.layout == b.state.layout;
        if (together && queues[a.queue].family != queues[b.queue].family) return false;
    }
    return true;
}

QueueUsage queue_usage(const HistoryInput& input, const std::vector<CellTouches>& roles) {
    std::set<QueueIndex> queues;
    std::set<uint32_t> families;
    bool in_turn = true;
    for (const CellTouches& cells : roles) {
        for (const std::vector<Touch>& touches : cells) {
            for (const Touch& touch : touches) queues.insert(touch.queue);
            in_turn = in_turn && one_family_at_a_time(touches, input.order->queues);
        }
    }
    for (const QueueIndex queue : queues) families.insert(input.order->queues[queue].family);
    const ResourceDecl& decl = *input.roles.front().decl;
    QueueUsage usage;
    // An import begins and ends every frame on the first queue, and the prologue runs there.
    if (decl.import && !queues.empty()) queues.insert(0);
    if (decl.import) families.insert(decl.import->family);
    if (decl.lifetime == ResourceLifetime::persistent && !queues.empty())
        families.insert(input.order->queues.front().family);
    usage.several_queues = queues.size() > 1;
    usage.several_families = families.size() > 1;
    usage.exclusive = usage.several_families && in_turn && decl.kind == ResourceKind::image &&
                      decl.lifetime == ResourceLifetime::transient;
    return usage;
}

// What one cell of all roles came to, in the settled frame.
struct Walked {
    std::vector<CellEvents> events;               // by role
    std::vector<Layout> entry;                    // by role
    std::vector<std::vector<LastUse>> last_uses;  // by role
};

template <class State>
Walked walk(State state, const std::vector<CellTouches>& roles, uint32_t cell, const ResourceDecl& decl) {
    const bool persistent = decl.lifetime == ResourceLifetime::persistent;
    Walked walked;
    for (int round = 0; round < (persistent ? kRoundsToSettle : 1); ++round) {
        walked = {};
        for (size_t age = 0; age < roles.size(); ++age) {
            const std::span<const Touch> touches(roles[age][cell]);
            if (persistent) state.next_frame();
            walked.entry.push_back(state.layout());
            // The oldest copy's memory becomes this frame's: what it holds is not needed any more.
            if (roles.size() > 1 && age == 0 && !touches.empty()) state.discard();
            CellEvents events;
            for (size_t i = 0; i < touches.size(); ++i) state.advance(touches.subspan(i), events);
            if (decl.import) state.release(decl.import->exit, events);
            walked.events.push_back(std::move(events));
            walked.last_uses.emplace_back();
            state.add_last_uses(walked.last_uses.back());
        }
    }
    return walked;
}

// Whether a frame does more to an import than to read it as it is.
bool changes(const ImportState& import, const std::vector<Touch>& touches) {
    const bool pending = ((import.entry.access | import.exit.access) & access::kAllWrites) != 0;
    return pending || import.entry.layout != import.exit.layout ||
           std::any_of(touches.begin(), touches.end(), [&](const Touch& touch) {
               return touch.writes || touch.state.layout != import.entry.layout;
           });
}

Walked walk_cell(const HistoryInput& input, const QueueUsage& usage, const QueueRules& rules,
                 const std::vector<CellTouches>& roles, uint32_t cell) {
    const ResourceDecl& decl = *input.roles.front().decl;
    const auto start = decl.lifetime == ResourceLifetime::persistent ? SubresourceState::Start::known
                                                                     : SubresourceState::Start::taken_over;
    if (usage.several_queues)
        return walk(decl.import
                        ? QueueWalk(rules, decl.import->entry, changes(*decl.import, roles.front()[cell]))
                        : QueueWalk(rules, start),
                    roles, cell, decl);
    return walk(decl.import ? SubresourceState(decl.import->entry) : SubresourceState(start), roles, cell,
                decl);
}

// Over all cells; only the latest of each queue counts for whoever waits on another queue.
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

// What no pass touches stays as the prologue's clear left it.
void add_entry(const SubresourceGrid& grid, ResourceKind kind, std::vector<Layout> layouts,
               ResourceHistory& history) {
    if (kind == ResourceKind::image)
        std::replace(layouts.begin(), layouts.end(), Layout::undefined, Layout::transfer_dst);
    for (const Layout layout : std::set<Layout>(layouts.begin(), layouts.end())) {
        std::vector<uint32_t> cells;
        for (uint32_t cell = 0; cell < layouts.size(); ++cell)
            if (layouts[cell] == layout) cells.push_back(cell);
        for (const SubresourceRange& range : grid.merged(cells))
            history.entry.push_back({kNoId, range, {stage::kNone, access::kNone, layout}, 0});
    }
}

SubresourceGrid grid_of(const HistoryInput& input) {
    std::vector<SubresourceRange> ranges;
    for (const Role& role : input.roles)
        for (const RangeTouch& touch : *role.touches) ranges.push_back(touch.range);
    return {*input.roles.front().decl, ranges};
}

}  // namespace

RingHistory resource_history(const HistoryInput& input) {
    const SubresourceGrid grid = grid_of(input);
    std::vector<CellTouches> roles;
    for (const Role& role : input.roles) roles.push_back(touches_by_cell(grid, *role.touches));
    const QueueUsage usage = queue_usage(input, roles);
    const QueueRules rules{input.order->queues, input.resource,
                           input.roles.front().decl->kind == ResourceKind::image, usage.exclusive,
                           static_cast<uint32_t>(input.order->order.size())};
    RingHistory ring;
    ring.roles.resize(roles.size());
    ring.concurrent = usage.several_families && !usage.exclusive;
    std::vector<std::vector<CellBarrier>> barriers(roles.size());
    std::vector<std::vector<Layout>> entries(roles.size());
    for (uint32_t cell = 0; cell < grid.cell_count(); ++cell) {
        Walked walked = walk_cell(input, usage, rules, roles, cell);
        for (size_t age = 0; age < roles.size(); ++age) {
            for (CellBarrier& barrier : walked.events[age].barriers) {
                barrier.cell = cell;
                barriers[age].push_back(barrier);
            }
            entries[age].push_back(walked.entry[age]);
            add_last_uses(walked.last_uses[age], ring.roles[age].last_uses);
            ring.dependencies.insert(ring.dependencies.end(), walked.events[age].dependencies.begin(),
                                     walked.events[age].dependencies.end());
        }
    }
    const bool persistent = input.roles.front().decl->lifetime == ResourceLifetime::persistent;
    for (size_t age = 0; age < roles.size(); ++age) {
        ring.roles[age].barriers = merged(grid, std::move(barriers[age]));
        if (persistent)
            add_entry(grid, input.roles.front().decl->kind, std::move(entries[age]), ring.roles[age]);
    }
    return ring;
}

}  // namespace weft
