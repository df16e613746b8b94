// Purpose: cuts an image into the coarsest boxes of mips × layers such that every range used in a frame is a
// union of them, so that each box has one history; and puts boxes with the same fate back together. Aspects
// are never cut: depth and stencil of one image always move together.
#pragma once

#include <cstdint>
#include <vector>

#include "weft/declaration.h"

namespace weft {

class SubresourceGrid {
 public:
    SubresourceGrid(const ResourceDecl& resource, const std::vector<SubresourceRange>& ranges);

    [[nodiscard]] uint32_t cell_count() const { return mip_count() * layer_count(); }
    // The cells of a range, ascending.
    [[nodiscard]] std::vector<uint32_t> cells_of(const SubresourceRange& range) const;
    // As few boxes as runs along mips, then layers, give. `cells` ascend.
    [[nodiscard]] std::vector<SubresourceRange> merged(const std::vector<uint32_t>& cells) const;

 private:
    [[nodiscard]] uint32_t mip_count() const { return static_cast<uint32_t>(mip_cuts_.size()) - 1; }
    [[nodiscard]] uint32_t layer_count() const { return static_cast<uint32_t>(layer_cuts_.size()) - 1; }

    std::vector<uint32_t> mip_cuts_;  // ascending, from 0 to the number of mips
    std::vector<uint32_t> layer_cuts_;
    AspectMask aspects_;
};

}  // namespace weft
