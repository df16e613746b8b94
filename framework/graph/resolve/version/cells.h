// Purpose: divides a resource into cells, the largest boxes of mips, layers and aspects that every use covers
// completely or not at all. Each cell has its own versions. Private to version().
#pragma once

#include <map>
#include <vector>

#include "graph/resolve/version.h"

namespace weft {

struct CellUse {
    PassId pass = kNoId;
    uint32_t use = 0;  // index into PassDecl::uses
    auto operator<=>(const CellUse&) const = default;
};

struct Cell {
    ResourceId resource = kNoId;
    SubresourceRange range;
    std::vector<CellUse> writers;  // one for each writing pass; in the order of versions once `ordered`
    std::vector<CellUse> readers;  // uses that only read
    bool ordered = false;
    // Reads pinned to a pass that does not write this cell: the writers that may come before the reader.
    std::map<CellUse, std::vector<PassId>> foreign_pins;

    [[nodiscard]] int writer_index(PassId pass) const;  // -1: doesn't write the cell
};

// Sorted by resource, then aspect, layer, mip.
[[nodiscard]] std::vector<Cell> make_cells(const VersionedGraph& graph, Reporter& reporter);
// Neighbouring boxes of one producer become one.
[[nodiscard]] std::vector<VersionSource> merge_sources(const std::vector<VersionSource>& cells);

}  // namespace weft
