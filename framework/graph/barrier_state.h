// Purpose: what is known of one subresource while a frame is walked: layout, unflushed writes, who has to be
// waited for, and for each stage the accesses already made visible. A barrier is needed only for a layout
// change, a pending write, an access not yet visible in its stage, or a write after anything. Source: the
// flush/invalidate model of Vulkan's memory model appendix, tracked as H.-K. Arntzen describes for Granite
// ("Render graphs and Vulkan – a deep dive", 2017), with visibility kept per stage.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "weft/plan.h"

namespace weft {

// All that one pass does to one subresource; several ports of a pass are one touch.
struct Touch {
    uint32_t position = 0;
    PassId pass = kNoId;
    AccessState state;
    bool writes = false;
    bool reads = false;
};

// What has to be waited for before the next conflicting access.
struct Pending {
    StageMask stages = stage::kNone;    // readers since the last barrier, or else the writer
    AccessMask writes = access::kNone;  // not flushed yet
    Layout layout = Layout::undefined;
    PassId pass = kNoId;   // the only one of them, else kNoId
    bool written = false;  // this frame wrote here
};

struct CellBarrier {
    uint32_t position = 0;
    uint32_t cell = 0;
    AccessState src;
    AccessState dst;
    BarrierReason reason = BarrierReason::raw;
    PassId from = kNoId;
};

class SubresourceState {
 public:
    // A transient or persistent resource: its first touch always needs a barrier (reason hand_over), whose
    // source only the caller knows.
    SubresourceState() = default;
    // An import, as it enters the frame.
    explicit SubresourceState(const AccessState& entry);

    // The barrier that the first of `touches` needs, if any. It also serves the reads that follow in the same
    // layout before the next write, so that they need none.
    [[nodiscard]] std::optional<CellBarrier> advance(std::span<const Touch> touches);
    [[nodiscard]] Pending pending() const;

 private:
    [[nodiscard]] bool visible(const AccessState& state) const;
    [[nodiscard]] bool needs_barrier(const Touch& touch) const;
    [[nodiscard]] BarrierReason reason(const Touch& touch) const;
    void apply_barrier(const CellBarrier& barrier);
    void apply_touch(const Touch& touch);
    void note_pass(PassId pass);

    bool taken_over_ = true;  // not touched yet, and the first touch takes memory over
    bool entered_ = false;    // an import that nothing has touched yet
    Layout layout_ = Layout::undefined;
    StageMask writer_stages_ = stage::kNone;
    AccessMask unflushed_ = access::kNone;
    StageMask reader_stages_ = stage::kNone;  // since the last barrier
    std::array<AccessMask, stage::kCount> visible_{};
    PassId pass_ = kNoId;  // the only pass behind the stages above
    bool several_ = false;
    bool written_ = false;
};

}  // namespace weft
