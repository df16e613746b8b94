// Purpose: the state of one subresource while a frame is walked on one queue: its layout, unflushed writes,
// the accesses to wait for, and for each stage the accesses already made visible. A barrier is needed only
// for a layout change, a pending write, an access not yet visible in its stage, or a write after any access.
// Source: the flush/invalidate model of Vulkan's memory model appendix, tracked as H.-K. Arntzen describes
// for Granite
// ("Render graphs and Vulkan – a deep dive", 2017), with visibility kept per stage.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "graph/sync/accesses.h"
#include "weft/plan.h"

namespace weft {

inline constexpr uint32_t kEpiloguePosition = UINT32_MAX;

// The last use of a subresource on one queue. The next user must wait for it.
struct LastUse {
    QueueIndex queue = 0;
    uint32_t position = 0;
    StageMask stages = stage::kNone;    // readers since the last barrier, or else the writer
    AccessMask writes = access::kNone;  // not flushed yet
    PassId pass = kNoId;                // the only one of them, else kNoId
};

struct CellBarrier {
    uint32_t position = 0;  // or kEpiloguePosition
    bool after = false;     // recorded after that position's pass
    uint32_t cell = 0;
    AccessState src;
    AccessState dst;
    BarrierReason reason = BarrierReason::raw;
    PassId from = kNoId;
    bool previous_frame = false;
    uint32_t src_family = 0, dst_family = 0;
    // Of a transfer: where its other half is recorded, and for whom. Both halves must name the same ranges.
    uint32_t pair_position = 0;
    AccessState pair_state;
};

// The barriers and dependencies of one cell in one frame.
struct CellSync {
    std::vector<CellBarrier> barriers;
    std::vector<QueueDependency> dependencies;
};

// One state for the first read and all that follow in its layout on its queue, up to the next write.
[[nodiscard]] AccessState merged_reads(std::span<const AccessEvent> events);

class SingleQueueTracker {
 public:
    enum class Start : uint8_t {
        taken_over,  // a transient: its first event always needs a barrier, whose source only the caller
                     // knows
        known,       // a persistent resource of which nothing is pending
    };
    explicit SingleQueueTracker(Start start) : taken_over_(start == Start::taken_over) {}
    // An import, as it enters the frame.
    explicit SingleQueueTracker(const AccessState& entry);

    // Adds the barrier that the first of `events` needs, if any. It also serves the reads that follow in the
    // same layout before the next write, so that they need none.
    void advance(std::span<const AccessEvent> events, CellSync& sync);
    // Returns an import to its exit state. A barrier is needed after writes, for another layout, and if the
    // next user may write data that this frame has read.
    void release(const AccessState& exit, CellSync& sync);
    // From here on events belong to the next frame.
    void next_frame() { previous_frame_ = true; }
    // The content is not needed any more.
    void discard();
    void add_last_uses(std::vector<LastUse>& all) const;
    [[nodiscard]] Layout layout() const { return layout_; }

 private:
    [[nodiscard]] StageMask pending_stages() const {
        return reader_stages_ != 0 ? reader_stages_ : writer_stages_;
    }
    [[nodiscard]] bool visible(const AccessState& state) const;
    [[nodiscard]] bool needs_barrier(const AccessEvent& event) const;
    [[nodiscard]] bool merges_render_pass(const AccessEvent& event) const;
    [[nodiscard]] BarrierReason reason(const AccessEvent& event) const;
    void apply_barrier(const CellBarrier& barrier);
    void apply_event(const AccessEvent& event);
    void merge_drawing(AccessEvent event);
    void note_pass(PassId pass);

    bool taken_over_ = true;  // not touched yet, and the first event takes memory over
    bool entered_ = false;    // an import that nothing has touched yet
    Layout layout_ = Layout::undefined;
    StageMask writer_stages_ = stage::kNone;
    AccessMask unflushed_ = access::kNone;
    StageMask reader_stages_ = stage::kNone;  // since the last barrier
    std::array<AccessMask, stage::kCount> visible_{};
    PassId pass_ = kNoId;  // the only pass behind the stages above
    bool several_ = false;
    bool written_ = false;
    bool touched_ = false;
    bool previous_frame_ = false;  // all of the above happened a frame ago
    QueueIndex queue_ = 0;         // of the last event
    uint32_t position_ = 0;
};

}  // namespace weft
