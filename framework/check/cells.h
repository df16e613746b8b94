// Purpose: stores the state of each subresource while the checker simulates a plan: its layout, the origin of
// its content, the queue family that owns it, and the accesses that later accesses must still wait for.
#pragma once

#include <algorithm>
#include <vector>

#include "check/ordering.h"
#include "weft/plan.h"

namespace weft::check {

// Describes where the current content of a subresource comes from.
struct Content {
    enum class Kind : uint8_t {
        undefined,
        outside,  // The content of an import, written by the program outside the graph.
        initial,  // The first-frame value of a persistent resource, set by the prologue.
        carried,  // Content that a persistent resource had at the end of `frame`.
        written,  // Content that `pass` wrote.
        // Content destroyed by `pass`, which wrote the same memory through the resource `through`.
        overwritten,
    } kind = Kind::undefined;
    PassId pass = kNoId;
    uint32_t frame = 0;
    ResourceId through = kNoId;
};

inline constexpr uint32_t kNoFamily = UINT32_MAX;

// The state of one subresource: one mip of one layer of one aspect of an image, or one piece of a buffer.
struct Cell {
    SubresourceRange range;
    Layout layout = Layout::undefined;
    Content content;
    bool has_write = false;
    AccessRecord write;  // The last write to the subresource, or its last layout transition.
    // The reads since `write`. If a wait for a later read also covers an earlier read, the earlier read is
    // left out.
    std::vector<AccessRecord> reads;
    // The queue family that owns the subresource. kNoFamily: the next family that uses the subresource
    // becomes the owner.
    uint32_t owner = kNoFamily;
    // Between the release and the acquire of an ownership transfer: the new owner, and the layout after the
    // transfer.
    uint32_t released_to = kNoFamily;
    Layout released_in = Layout::undefined;
    // Number of the last vkCmdPipelineBarrier2 call that was applied to this cell, counted over all queues.
    uint64_t last_batch = 0;
};

// The cells of one resource.
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
    std::vector<Cell> cells_;  // All cells, ordered by aspect, then mip, then layer.
};

}  // namespace weft::check
