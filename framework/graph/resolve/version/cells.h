// Purpose: divides a resource into cells: boxes of mips, layers and aspects that every use covers completely
// or not at all. Versions are tracked per cell. Private to version().
#pragma once

#include <map>
#include <set>
#include <vector>

#include "graph/resolve/version.h"

namespace weft {

struct CellUse {
    PassId pass = kNoId;
    // Index into PassDecl::uses of the pass.
    uint32_t use = 0;
    auto operator<=>(const CellUse&) const = default;
};

struct Cell {
    ResourceId resource = kNoId;
    SubresourceRange range;
    // The passes that write the cell (a part of a resource), one use for each pass. If `ordered` is true,
    // they are in the order of their versions.
    std::vector<CellUse> writers;
    // The uses that read the cell and do not write it.
    std::vector<CellUse> readers;
    // Readers in a group that see the content from before their round: their ports have "wakes": false, and
    // their own round writes the cell.
    std::set<CellUse> before_round;
    bool ordered = false;
    // Key: a use that names, with `@pass`, a pass that does not write this cell. Value: the writers of the
    // cell that do not run after the named pass. The pass of the use runs after all of these writers.
    std::map<CellUse, std::vector<PassId>> foreign_pins;

    // Returns the index into `writers` of a pass, or -1 if the pass does not write the cell.
    [[nodiscard]] int writer_index(PassId pass) const;
};

// Divides all used resources into cells. The cells are sorted by resource, then aspect, layer and mip.
[[nodiscard]] std::vector<Cell> make_cells(const VersionedGraph& graph, Reporter& reporter);
// Merges neighbouring ranges that have the same producer. `cells` must be sorted by aspect, layer and mip.
[[nodiscard]] std::vector<VersionSource> merge_sources(const std::vector<VersionSource>& cells);

}  // namespace weft
