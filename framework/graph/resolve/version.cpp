#include "graph/resolve/version.h"

#include "graph/resolve/version/connect_versions.h"
#include "graph/resolve/version/group_rounds.h"
#include "graph/resolve/version/order_writers.h"

namespace weft {
namespace {

// Marks each write that overlaps an input of the same pass as a write in place: the pass reads the previous
// version and writes the next one.
void find_in_place_writes(std::vector<BoundPass>& passes) {
    for (BoundPass& pass : passes) {
        for (size_t out = 0; out < pass.uses.size(); ++out) {
            const UseDecl& written = pass.uses[out];
            if (!writes(written.access)) continue;
            for (const UseDecl& in : pass.uses) {
                const bool seen = in.access != Access::none && !writes(in.access);
                if (seen && in.resource == written.resource && overlaps(in.range, written.range))
                    pass.ports[out].rank = WriteRank::in_place;
            }
        }
    }
}

}  // namespace

VersionedGraph version(const Declared& declared, FormattedGraph graph, Suspects suspects,
                       Reporter& reporter) {
    VersionedGraph versioned{.resources = std::move(graph.resources),
                             .passes = std::move(graph.passes),
                             .edges = {},
                             .suspects = std::move(suspects)};
    find_in_place_writes(versioned.passes);
    std::vector<Cell> cells = separate_rounds(declared, make_cells(versioned, reporter), versioned, reporter);
    if (!order_writers(declared, versioned, cells, reporter)) return versioned;
    connect_versions(declared, cells, versioned, reporter);
    connect_switched(declared, cells, versioned, reporter);
    check_sliced_reads(declared, cells, versioned, reporter);
    check_group_order(declared, versioned, reporter);
    find_rest_units(declared, cells, versioned, reporter);
    agree_on_layouts(declared, cells, versioned);
    return versioned;
}

}  // namespace weft
