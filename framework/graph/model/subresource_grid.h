// Purpose: divides an image into cells. A cell is a range of mips in a range of layers. The cells are as
// large as possible, but each range that a pass uses in the frame consists of whole cells. So the state of an
// image can be tracked per cell. Cells that need the same barrier are merged into ranges again. Aspects are
// not divided, because depth and stencil of an image always change together.
#pragma once

#include <cstdint>
#include <vector>

#include "weft/declaration.h"

namespace weft {

class SubresourceGrid {
 public:
    SubresourceGrid(const ResourceDecl& resource, const std::vector<SubresourceRange>& ranges);

    [[nodiscard]] uint32_t cell_count() const { return mip_count() * layer_count(); }
    // Returns the indices of the cells that make up a range, in ascending order. The index of a cell is
    // i + mip_count() × j for the cell at mip_cuts_[i] and layer_cuts_[j].
    [[nodiscard]] std::vector<uint32_t> cells_of(const SubresourceRange& range) const;
    // Merges cells into few ranges: first neighbouring mips of a layer, then neighbouring layers with the
    // same mips. The indices in `cells` must ascend.
    [[nodiscard]] std::vector<SubresourceRange> merge(const std::vector<uint32_t>& cells) const;

 private:
    [[nodiscard]] uint32_t mip_count() const { return static_cast<uint32_t>(mip_cuts_.size()) - 1; }
    [[nodiscard]] uint32_t layer_count() const { return static_cast<uint32_t>(layer_cuts_.size()) - 1; }

    // Boundaries of the cells in ascending order. The cell at mip_cuts_[i] contains the mips from
    // mip_cuts_[i] to mip_cuts_[i + 1] - 1. The first value is 0 and the last is the number of mips of the
    // image. layer_cuts_ does the same for layers.
    std::vector<uint32_t> mip_cuts_;
    std::vector<uint32_t> layer_cuts_;
    AspectMask aspects_;
};

}  // namespace weft
