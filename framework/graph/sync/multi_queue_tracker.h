// Purpose: tracks the state of one subresource that several queues use. Between queues, a semaphore wait
// orders the accesses and makes all writes available and visible. Barriers are needed only between accesses
// on the same queue, for layout changes, and for ownership transfers between queue families.
#pragma once

#include <optional>

#include "graph/sync/single_queue_tracker.h"

namespace weft {

// Properties of a resource that do not change during tracking. `queues` are the queues of the schedule.
// `exclusive` means that one queue family at a time owns the resource.
struct QueueRules {
    const std::vector<LogicalQueue>& queues;
    ResourceId resource = kNoId;
    bool image = true;
    bool exclusive = false;
    Position epilogue = 0;  // Position after the last pass; it represents the end of the frame.
};

// Returns true if a frame with these accesses writes the import or changes its layout. Also returns true if
// the program writes the import before or after the frame (ImportState::entry and exit).
[[nodiscard]] bool changes_import(const ImportState& import, std::span<const AccessEvent> events);

class MultiQueueTracker {
 public:
    MultiQueueTracker(const QueueRules& rules, SingleQueueTracker::Start start)
        : rules_(&rules), taken_over_(start == SingleQueueTracker::Start::taken_over) {}
    // Tracks an import in its entry state. If `changes` is true, the frame changes the import's content or
    // layout, so the first access must wait for the end of the previous frame on queue 0.
    MultiQueueTracker(const QueueRules& rules, const AccessState& entry, bool changes);

    // advance() and the functions below have the same meaning as in SingleQueueTracker.
    void advance(std::span<const AccessEvent> events, CellSync& sync);
    void release(const AccessState& exit, CellSync& sync);
    void next_frame();
    void discard();
    void add_last_uses(std::vector<LastUse>& all) const;
    [[nodiscard]] Layout layout() const { return layout_; }

 private:
    // An earlier access to the subresource, for which later accesses may have to wait.
    struct Past {
        Position position = 0;
        QueueIndex queue = kGraphicsQueue;
        StageMask stages = stage::kNone;
        PassId pass = kNoId;
        bool previous_frame = false;
    };

    [[nodiscard]] uint32_t family(QueueIndex queue) const { return rules_->queues[queue].family; }
    [[nodiscard]] bool starts_anew(const AccessEvent& event) const;
    [[nodiscard]] bool merges_render_pass(const AccessEvent& event) const;
    [[nodiscard]] bool visible(const AccessState& state) const;
    [[nodiscard]] AccessMask unflushed_on(QueueIndex queue) const {
        return source_ && source_->queue == queue ? unflushed_ : access::kNone;
    }
    [[nodiscard]] std::span<const Past> predecessors() const;
    [[nodiscard]] std::optional<Past> common_past(std::span<const AccessEvent> events) const;
    void merge_drawing(const AccessEvent& event);
    void join(std::span<const AccessEvent> events, CellSync& sync);
    void begin(std::span<const AccessEvent> events, CellSync& sync);
    void share(const Past& past, std::span<const AccessEvent> events, CellSync& sync);
    void transfer(std::span<const AccessEvent> events, CellSync& sync);
    void change(std::span<const AccessEvent> events, CellSync& sync);
    void wait_for(const Past& past, Position position, CellSync& sync) const;
    void note_source(const AccessEvent& event, const AccessState& made_visible);
    [[nodiscard]] BarrierReason reason(const AccessEvent& event) const;

    const QueueRules* rules_;
    bool taken_over_ = false;
    bool entered_ = false;
    bool written_ = false;
    // True for an import without a pending write: all accesses see the content of the import until the frame
    // changes the content or the layout.
    bool enters_visible_ = false;
    bool touched_ = false;
    Layout layout_ = Layout::undefined;
    // The last write or layout transition. It determines the current content and layout.
    std::optional<Past> source_;
    // Writes of the last writer that no barrier on the writer's queue has made available yet.
    AccessMask unflushed_ = access::kNone;
    // All writes of the last writer, also those that a barrier has made available already. A later barrier
    // that does not wait for the stages of that first barrier must make the writes available again.
    AccessMask source_writes_ = access::kNone;
    // Index: bit of the stage. Access types to which the content is visible, on the queue of the last writer.
    std::array<AccessMask, stage::kCount> visible_{};
    std::vector<Past> readers_;  // All readers since the last write or layout transition.
    uint32_t owner_family_ = 0;
};

}  // namespace weft
