// Purpose: the state of one subresource that several queues use. A semaphore waits for the other queues and
// makes all their writes available and visible. Barriers remain for accesses on the same queue, for layouts,
// and for the ownership of queue families.
#pragma once

#include <optional>

#include "graph/sync/single_queue_tracker.h"

namespace weft {

// Fixed for a resource: the queues of its schedule, and whether it belongs to one family at a time.
struct QueueRules {
    const std::vector<LogicalQueue>& queues;
    ResourceId resource = kNoId;
    bool image = true;
    bool exclusive = false;
    uint32_t epilogue = 0;  // the position that stands for the end of queue 0's frame
};

class MultiQueueTracker {
 public:
    MultiQueueTracker(const QueueRules& rules, SingleQueueTracker::Start start)
        : rules_(&rules), taken_over_(start == SingleQueueTracker::Start::taken_over) {}
    // An import, as queue 0 left it at the end of the frame before; or as it always is, where the frame
    // changes neither its content nor its layout.
    MultiQueueTracker(const QueueRules& rules, const AccessState& entry, bool changes);

    // As SingleQueueTracker's.
    void advance(std::span<const AccessEvent> events, CellSync& sync);
    void release(const AccessState& exit, CellSync& sync);
    void next_frame();
    void discard();
    void add_last_uses(std::vector<LastUse>& all) const;
    [[nodiscard]] Layout layout() const { return layout_; }

 private:
    struct Past {
        uint32_t position = 0;
        QueueIndex queue = 0;
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
    [[nodiscard]] std::vector<Past> predecessors() const;
    [[nodiscard]] std::optional<Past> common_past(std::span<const AccessEvent> events) const;
    void merge_drawing(const AccessEvent& event);
    void join(std::span<const AccessEvent> events, CellSync& sync);
    void begin(std::span<const AccessEvent> events, CellSync& sync);
    void share(const Past& past, std::span<const AccessEvent> events, CellSync& sync);
    void transfer(std::span<const AccessEvent> events, CellSync& sync);
    void change(std::span<const AccessEvent> events, CellSync& sync);
    void wait_for(const Past& past, uint32_t position, CellSync& sync) const;
    void note_source(const AccessEvent& event, const AccessState& made_visible);
    [[nodiscard]] BarrierReason reason(const AccessEvent& event) const;

    const QueueRules* rules_;
    bool taken_over_ = false;
    bool entered_ = false;
    bool written_ = false;
    bool touched_ = false;
    Layout layout_ = Layout::undefined;
    std::optional<Past> source_;                // whose end makes content and layout what they are
    AccessMask unflushed_ = access::kNone;      // on the source's queue
    AccessMask source_writes_ = access::kNone;  // flushed anew by barriers that do not chain to the first one
    std::array<AccessMask, stage::kCount> visible_{};  // on the source's queue
    std::vector<Past> readers_;                        // since then
    uint32_t owner_family_ = 0;
};

}  // namespace weft
