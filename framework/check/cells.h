// Purpose: the replay's state of each subresource: its layout, the origin of its content, the queue family
// that owns it, and the accesses that later ones must still wait for.
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
        outside,      // content of an import
        initial,      // a persistent resource's first-frame value
        carried,      // a persistent resource's content at the end of `frame`
        written,      // written by `pass`
        overwritten,  // destroyed by `pass`, which wrote the same memory through resource `through`
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
    std::vector<AccessRecord> reads;         // reads since that write, without those that later reads imply
    uint32_t owner = kNoFamily;              // the queue family that owns it; kNoFamily: the next family that
                                             // uses it becomes the owner
    uint32_t released_to = kNoFamily;        // set between release and acquire: the family that will own it,
    Layout released_in = Layout::undefined;  // and the layout it will have
    uint64_t last_batch = 0;                 // number of the last barrier batch on this cell, counted over
                                             // all queues
};

// All cells of one resource.
class Cells {
 public:
    explicit Cells(const ResourceDecl& resource);

    [[nodiscard]] auto begin() { return cells_.begin(); }
    [[nodiscard]] auto end() { return cells_.end(); }
    // Calls `visit` for each cell of the range; parts outside the resource are ignored.
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
    std::vector<Cell> cells_;  // indexed by aspect, mip, layer
};

}  // namespace weft::check
