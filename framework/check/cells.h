// Purpose: what the replay knows of each subresource: its layout, whose values it holds, which queue family
// owns it, and which accesses are still to be waited for.
#pragma once

#include <algorithm>
#include <vector>

#include "check/ordering.h"
#include "weft/plan.h"

namespace weft::check {

// The origin of the values in a subresource.
struct Content {
    enum class Kind : uint8_t {
        undefined,
        outside,      // an import's
        initial,      // a persistent resource's first-frame value
        carried,      // what a persistent resource held at the end of `frame`
        written,      // by `pass`
        overwritten,  // by `pass`, through `through`
    } kind = Kind::undefined;
    PassId pass = kNoId;
    uint32_t frame = 0;
    ResourceId through = kNoId;
};

inline constexpr uint32_t kNoFamily = UINT32_MAX;

// One mip and layer of one aspect, or a buffer.
struct Cell {
    SubresourceRange range;
    Layout layout = Layout::undefined;
    Content content;
    bool has_write = false;
    AccessRecord write;                      // the last write or transition
    std::vector<AccessRecord> reads;         // since then, those that are not implied by later ones
    uint32_t owner = kNoFamily;              // the family that may use it; kNoFamily: the next one to do so
    uint32_t released_to = kNoFamily;        // on its way to that family, and
    Layout released_in = Layout::undefined;  // into that layout
    uint64_t last_batch = 0;                 // of barriers, counted over all queues, that was on this cell
};

// Those of one resource.
class Cells {
 public:
    explicit Cells(const ResourceDecl& resource);

    // The resource that has begun to take over all of this one's memory since its last use, and waited for
    // that use. A third one that takes the memory over waits for that resource, and so for this one. The
    // parts of that resource itself take their memory over one by one.
    ResourceId superseded_by = kNoId;

    [[nodiscard]] auto begin() { return cells_.begin(); }
    [[nodiscard]] auto end() { return cells_.end(); }
    // Calls `visit` for each cell of the range; what lies beyond the resource is left out.
    template <class Visit>
    void each(const SubresourceRange& range, Visit visit) {
        const uint32_t last_mip = std::min(whole_.mips, range.mip + range.mips);
        const uint32_t last_layer = std::min(whole_.layers, range.layer + range.layers);
        size_t plane = 0;
        for (AspectMask rest = whole_.aspects; rest != 0; rest &= rest - 1, ++plane) {
            if ((rest & -rest & range.aspects) == 0) continue;
            for (uint32_t mip = range.mip; mip < last_mip; ++mip)
                for (uint32_t layer = range.layer; layer < last_layer; ++layer)
                    visit(cells_[(plane * whole_.mips + mip) * whole_.layers + layer]);
        }
    }

 private:
    SubresourceRange whole_;
    std::vector<Cell> cells_;  // by aspect, mip, layer
};

}  // namespace weft::check
