// Purpose: tracks the state of one subresource through a frame on one queue: its layout, writes not yet made
// available, accesses to wait for, and for each stage the accesses to which the content is visible. A barrier
// is needed only for a layout change, a pending write, an access to which the content is not visible yet, or
// a write after any access.
// Source: the availability and visibility rules of Vulkan's appendix "Memory Model", tracked as H.-K. Arntzen
// describes for Granite ("Render graphs and Vulkan – a deep dive", 2017), but with visibility for each stage.
#pragma once

#include <array>
#include <span>
#include <tuple>
#include <vector>

#include "graph/sync/accesses.h"
#include "weft/plan.h"

namespace weft {

inline constexpr Position kEpiloguePosition = kNoId;

// The last use of a subresource on one queue. The next user must wait for it.
struct LastUse {
    QueueIndex queue = kGraphicsQueue;
    Position position = 0;
    // Stages of the reads since the last barrier; without such reads, the stages of the last write.
    StageMask stages = stage::kNone;
    AccessMask writes = access::kNone;  // Writes of this use that no barrier has made available yet.
    PassId pass = kNoId;                // The pass of these accesses; kNoId if there are several.
};

struct CellBarrier {
    // Schedule position at which the barrier is recorded; kEpiloguePosition means the end of the frame.
    Position position = 0;
    bool after = false;  // True: the barrier is recorded after the pass at `position`, not before it.
    uint32_t cell = 0;
    AccessState src;
    AccessState dst;
    BarrierReason reason = BarrierReason::raw;
    PassId from = kNoId;          // The pass to wait for; kNoId if there is no single such pass.
    bool previous_frame = false;  // True if the accesses to wait for are in the previous frame.
    uint32_t src_family = 0, dst_family = 0;
    // Only for an ownership transfer between queue families, which needs two barriers: a release and an
    // acquire. The release stores the position and the state of the acquire here, and the acquire stores
    // those of the release. Barriers of several cells (blocks of subresources) are merged only if these
    // values are equal too. So release and acquire get the same ranges.
    Position pair_position = 0;
    AccessState pair_state;
};

// Returns all properties of a barrier except its cell and the layout of `pair_state`. That layout adds no
// information, because it is one of the barrier's own two layouts. Barriers with equal keys are
// merged into one barrier for all their cells.
[[nodiscard]] inline auto merge_key(const CellBarrier& b) {
    return std::make_tuple(b.position, b.after, b.reason, b.from, b.src.stages, b.src.access, b.src.layout,
                           b.dst.stages, b.dst.access, b.dst.layout, b.previous_frame, b.src_family,
                           b.dst_family, b.pair_position, b.pair_state.stages, b.pair_state.access);
}

// The barriers of one cell (a block of subresources with the same accesses) in one frame, and its
// dependencies between queues.
struct CellSync {
    std::vector<CellBarrier> barriers;
    std::vector<QueueDependency> dependencies;
};

// Returns the union of the stages and accesses of the first read and of the reads that follow it on the same
// queue, in the same layout and before the next write.
[[nodiscard]] AccessState merge_reads(std::span<const AccessEvent> events);

class SingleQueueTracker {
 public:
    enum class Start : uint8_t {
        // A transient resource. Its first access always needs a barrier, because the resource takes memory
        // over. barriers() fills in the source of that barrier later: the last users of the memory.
        taken_over,
        known,  // A persistent resource: its layout is known, and no access is pending.
    };
    explicit SingleQueueTracker(Start start) : taken_over_(start == Start::taken_over) {}
    // Starts with an import in its entry state: the state in which the program passes the import to the
    // frame.
    explicit SingleQueueTracker(const AccessState& entry);

    // Processes the first of `events`, and adds the barrier that it needs, if any. `events` are all events
    // that are not processed yet. The barrier for a read also covers the following reads in the same layout
    // before the next write, so these reads need no barrier.
    void advance(std::span<const AccessEvent> events, CellSync& sync);
    // Adds the barrier at the end of the frame that brings an import into its exit state. The barrier is
    // needed in these cases: the frame wrote the import; the layout is not that of the exit state; the frame
    // changed the layout and restored it, and the content is not visible to the accesses of the exit state;
    // or the next user may overwrite data that this frame read.
    void release(const AccessState& exit, CellSync& sync);
    // Starts the next frame: all accesses so far belong to the previous frame.
    void next_frame() { previous_frame_ = true; }
    // Marks the content as not needed any more: the layout becomes UNDEFINED.
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

    bool taken_over_ = true;  // True until the first access to a transient; that access takes memory over.
    bool entered_ = false;    // True until the first access to an import in this frame.
    Layout layout_ = Layout::undefined;
    StageMask writer_stages_ = stage::kNone;
    AccessMask unflushed_ = access::kNone;    // Writes that no barrier has made available yet.
    StageMask reader_stages_ = stage::kNone;  // Stages that have read since the last barrier.
    // Index: bit of the stage. Access types of this stage to which the content is visible.
    std::array<AccessMask, stage::kCount> visible_{};
    PassId pass_ = kNoId;  // The pass of the pending accesses; kNoId if there are several.
    bool several_ = false;
    bool written_ = false;
    // True for an import without a pending write: all accesses see the content of the import until the frame
    // changes the content or the layout.
    bool enters_visible_ = false;
    bool touched_ = false;
    bool previous_frame_ = false;        // True if the last access was in the previous frame.
    QueueIndex queue_ = kGraphicsQueue;  // Queue of the last access to the subresource.
    Position position_ = 0;
};

}  // namespace weft
