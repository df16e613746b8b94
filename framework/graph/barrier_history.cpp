#include "graph/barrier_history.h"

#include <algorithm>
#include <tuple>

#include "graph/subresource_grid.h"

namespace weft {
namespace {

// Everything but the cell: barriers with equal keys become one over the union of their cells.
auto fate(const CellBarrier& b) {
    return std::make_tuple(b.position, b.reason, b.from, b.src.stages, b.src.access, b.src.layout,
                           b.dst.stages, b.dst.access, b.dst.layout);
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
        }
    }
    return cells;
}

// Needed after writes, for another layout, and where whoever comes next may write what this frame has read.
void release(const ImportState& import, const Pending& left, bool touched, uint32_t cell,
             std::vector<CellBarrier>& barriers) {
    const bool overwritten_next = touched && (import.exit.access & access::kAllWrites) != 0;
    if (!left.written && !overwritten_next && left.layout == import.exit.layout) return;
    barriers.push_back({.position = kEpiloguePosition,
                        .cell = cell,
                        .src = {left.stages, left.writes, left.layout},
                        .dst = import.exit,
                        .reason = BarrierReason::release_import,
                        .from = left.pass});
}

void add_pending(const Pending& cell, Pending& all) {
    const bool first = all.stages == stage::kNone;
    all.pass = first || all.pass == cell.pass ? cell.pass : kNoId;
    all.stages |= cell.stages;
    all.writes |= cell.writes;
    all.layout = cell.layout;
    all.written = all.written || cell.written;
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
            decl.reason = barrier.reason;
            decl.from = barrier.from;
            result.push_back({barrier.position, decl});
        }
    }
    return result;
}

}  // namespace

ResourceHistory resource_history(const ResourceDecl& resource, const std::vector<RangeTouch>& touches) {
    std::vector<SubresourceRange> ranges;
    for (const RangeTouch& touch : touches) ranges.push_back(touch.range);
    const SubresourceGrid grid(resource, ranges);
    const std::vector<std::vector<Touch>> cells = touches_by_cell(grid, touches);
    std::vector<CellBarrier> barriers;
    ResourceHistory history;
    for (uint32_t cell = 0; cell < cells.size(); ++cell) {
        SubresourceState state =
            resource.import ? SubresourceState(resource.import->entry) : SubresourceState();
        const std::span<const Touch> all(cells[cell]);
        for (size_t i = 0; i < all.size(); ++i) {
            if (auto barrier = state.advance(all.subspan(i))) {
                barrier->cell = cell;
                barriers.push_back(*barrier);
            }
        }
        if (!all.empty()) add_pending(state.pending(), history.last);
        if (resource.import) release(*resource.import, state.pending(), !all.empty(), cell, barriers);
    }
    history.barriers = merged(grid, std::move(barriers));
    return history;
}

}  // namespace weft
