// Purpose: divides an image into the coarsest boxes of mips × layers such that every range used in a frame is
// a union of boxes, so that each box has one history; and merges boxes with equal results again. Aspects are
// not divided: depth and stencil of one image always change together.
#pragma once

#include <cstdint>
#include <vector>

#include "weft/declaration.h"

namespace weft {

class SubresourceGrid {
 public:
    SubresourceGrid(const ResourceDecl& resource, const std::vector<SubresourceRange>& ranges);

    [[nodiscard]] uint32_t cell_count() const { return mip_count() * layer_count(); }
    // The cells of a range, in ascending order.
    [[nodiscard]] std::vector<uint32_t> cells_of(const SubresourceRange& range) const;
    // Merges cells into few boxes: first into runs along mips, then along layers. `cells` must ascend.
    [[nodiscard]] std::vector<SubresourceRange> merge(const std::vector<uint32_t>& cells) const;

 private:
    [[nodiscard]] uint32_t mip_count() const { return static_cast<uint32_t>(mip_cuts_.size()) - 1; }
    [[nodiscard]] uint32_t layer_count() const { return static_cast<uint32_t>(layer_cuts_.size()) - 1; }

    std::vector<uint32_t> mip_cuts_;  // in ascending order, from 0 to the number of mips
    std::vector<uint32_t> layer_cuts_;
    AspectMask aspects_;
};

}  // namespace weft
