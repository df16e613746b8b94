#include "graph/resolve/version/cells.h"

#include <algorithm>
#include <tuple>

namespace weft {
namespace {

constexpr uint64_t kStepsPerCell = 4;

void sort_unique(std::vector<uint32_t>& values) {
    std::ranges::sort(values);
    values.erase(std::unique(values.begin(), values.end()), values.end());
}

// The mips and layers at which a use of the resource begins or ends. They are the borders of the cells.
// `aspects` divides the resource into cells by aspect. It has a single mask if all uses have the same
// aspects, otherwise one mask with a single bit for each aspect.
struct Cuts {
    std::vector<uint32_t> mips, layers;
    std::vector<AspectMask> aspects;
};

Cuts find_cuts(const VersionedGraph& graph, const std::vector<CellUse>& uses) {
    Cuts cuts;
    AspectMask all = 0;
    bool differ = false;
    for (const CellUse& u : uses) {
        const SubresourceRange& r = graph.passes[u.pass].uses[u.use].range;
        cuts.mips.insert(cuts.mips.end(), {r.mip, r.mip + r.mips});
        cuts.layers.insert(cuts.layers.end(), {r.layer, r.layer + r.layers});
        differ |= all != 0 && all != r.aspects;
        all |= r.aspects;
    }
    sort_unique(cuts.mips);
    sort_unique(cuts.layers);
    if (!differ) {
        cuts.aspects.push_back(all);
        return cuts;
    }
    for (const AspectMask bit : {aspect::kColor, aspect::kDepth, aspect::kStencil}) {
        if (all & bit) cuts.aspects.push_back(bit);
    }
    return cuts;
}

void add_use(const VersionedGraph& graph, const CellUse& use, Cell& cell) {
    if (!writes(graph.passes[use.pass].uses[use.use].access)) {
        cell.readers.push_back(use);
    } else if (cell.writers.empty() || cell.writers.back().pass != use.pass) {
        // The uses are sorted by pass, so a pass that already writes the cell is the last one in `writers`.
        cell.writers.push_back(use);
    }
}

bool all_of_one_range(const VersionedGraph& graph, const std::vector<CellUse>& uses) {
    const auto range = [&](const CellUse& u) -> const SubresourceRange& {
        return graph.passes[u.pass].uses[u.use].range;
    };
    return std::ranges::all_of(uses, [&](const CellUse& u) { return range(u) == range(uses.front()); });
}

void cut_resource(const VersionedGraph& graph, ResourceId resource, const std::vector<CellUse>& uses,
                  std::vector<Cell>& cells, Reporter& reporter) {
    if (all_of_one_range(graph, uses)) {
        reporter.spend(kStepsPerCell + 2 * uses.size(), graph.resources[resource].loc);
        Cell& cell = cells.emplace_back();
        cell.resource = resource;
        cell.range = graph.passes[uses.front().pass].uses[uses.front().use].range;
        for (const CellUse& u : uses) add_use(graph, u, cell);
        return;
    }
    const Cuts cuts = find_cuts(graph, uses);
    const size_t first = cells.size();
    const size_t rows = cuts.layers.size() - 1;
    const size_t columns = cuts.mips.size() - 1;
    reporter.spend(kStepsPerCell * cuts.aspects.size() * rows * columns, graph.resources[resource].loc);
    for (const AspectMask aspects : cuts.aspects) {
        for (size_t l = 0; l < rows; ++l) {
            for (size_t m = 0; m < columns; ++m) {
                Cell cell;
                cell.resource = resource;
                cell.range = {cuts.mips[m], cuts.mips[m + 1] - cuts.mips[m], cuts.layers[l],
                              cuts.layers[l + 1] - cuts.layers[l], aspects};
                cells.push_back(std::move(cell));
            }
        }
    }
    const auto index = [](const std::vector<uint32_t>& axis, uint32_t value) {
        return static_cast<size_t>(std::ranges::lower_bound(axis, value) - axis.begin());
    };
    for (const CellUse& u : uses) {
        const SubresourceRange& r = graph.passes[u.pass].uses[u.use].range;
        for (size_t a = 0; a < cuts.aspects.size(); ++a) {
            if (!(cuts.aspects[a] & r.aspects)) continue;
            for (size_t l = index(cuts.layers, r.layer); cuts.layers[l] < r.layer + r.layers; ++l) {
                reporter.spend(1 + index(cuts.mips, r.mip + r.mips) - index(cuts.mips, r.mip),
                               graph.passes[u.pass].uses[u.use].loc);
                for (size_t m = index(cuts.mips, r.mip); cuts.mips[m] < r.mip + r.mips; ++m) {
                    add_use(graph, u, cells[first + (a * rows + l) * columns + m]);
                }
            }
        }
    }
}

bool joins_mips(const SubresourceRange& a, const SubresourceRange& b) {
    return a.aspects == b.aspects && a.layer == b.layer && a.layers == b.layers && a.mip + a.mips == b.mip;
}

bool joins_layers(const SubresourceRange& a, const SubresourceRange& b) {
    return a.aspects == b.aspects && a.mip == b.mip && a.mips == b.mips && a.layer + a.layers == b.layer;
}

}  // namespace

int Cell::writer_index(PassId pass) const {
    const auto found = std::ranges::find(writers, pass, &CellUse::pass);
    return found == writers.end() ? -1 : static_cast<int>(found - writers.begin());
}

std::vector<Cell> make_cells(const VersionedGraph& graph, Reporter& reporter) {
    std::vector<std::vector<CellUse>> uses_of(graph.resources.size());
    for (PassId pass(0); pass < graph.passes.size(); ++pass) {
        const std::vector<UseDecl>& uses = graph.passes[pass].uses;
        for (uint32_t i = 0; i < uses.size(); ++i) {
            if (uses[i].access != Access::none) uses_of[uses[i].resource].push_back({pass, i});
        }
    }
    std::vector<Cell> cells;
    cells.reserve(uses_of.size());
    for (ResourceId resource(0); resource < uses_of.size(); ++resource) {
        if (!uses_of[resource].empty()) cut_resource(graph, resource, uses_of[resource], cells, reporter);
    }
    return cells;
}

std::vector<VersionSource> merge_sources(const std::vector<VersionSource>& cells) {
    if (cells.size() <= 1) return cells;
    std::vector<VersionSource> rows;
    for (const VersionSource& cell : cells) {
        if (!rows.empty() && rows.back().producer == cell.producer &&
            joins_mips(rows.back().range, cell.range)) {
            rows.back().range.mips += cell.range.mips;
        } else {
            rows.push_back(cell);
        }
    }
    // A row is a range of adjacent mips. Rows are sorted by aspect, then by layer. So a row can extend only
    // the last box with the same producer, aspects and mips. `last` contains the index of that box.
    std::map<std::tuple<PassId, AspectMask, uint32_t, uint32_t>, size_t> last;
    std::vector<VersionSource> boxes;
    for (const VersionSource& row : rows) {
        const auto [above, is_new] =
            last.try_emplace({row.producer, row.range.aspects, row.range.mip, row.range.mips}, boxes.size());
        if (!is_new && joins_layers(boxes[above->second].range, row.range)) {
            boxes[above->second].range.layers += row.range.layers;
        } else {
            above->second = boxes.size();
            boxes.push_back(row);
        }
    }
    return boxes;
}

}  // namespace weft
