#include "graph/sync/single_queue_tracker.h"

#include <bit>

namespace weft {
namespace {

// Returns the number of the lowest stage in the mask.
size_t first_stage(StageMask stages) {
    return static_cast<size_t>(std::countr_zero(stages));
}

}  // namespace

AccessState merge_reads(std::span<const AccessEvent> events) {
    AccessState state = events.front().state;
    for (const AccessEvent& event : events) {
        if (event.writes || event.state.layout != state.layout) break;
        if (event.queue != events.front().queue) continue;
        state.stages |= event.state.stages;
        state.access |= event.state.access;
    }
    return state;
}

SingleQueueTracker::SingleQueueTracker(const AccessState& entry)
    : taken_over_(false), entered_(true), layout_(entry.layout) {
    unflushed_ = entry.access & access::kAllWrites;
    if (unflushed_ != 0) {
        writer_stages_ = entry.stages;
        return;
    }
    reader_stages_ = entry.stages;
    enters_visible_ = true;
    // The import has no pending write. So all accesses already see its content, and need no barrier for that.
    visible_.fill(~access::kNone);
}

bool SingleQueueTracker::visible(const AccessState& state) const {
    for (StageMask left = state.stages; left != 0; left &= left - 1)
        if ((state.access & ~visible_[first_stage(left)]) != 0) return false;
    return true;
}

bool SingleQueueTracker::needs_barrier(const AccessEvent& event) const {
    if (taken_over_ || layout_ != event.state.layout || unflushed_ != 0) return true;
    if (event.writes) return (reader_stages_ | writer_stages_) != 0;
    return !visible(event.state);
}

BarrierReason SingleQueueTracker::reason(const AccessEvent& event) const {
    if (taken_over_) return BarrierReason::alias;
    if (entered_) return BarrierReason::acquire_import;
    if (unflushed_ != 0) return event.reads ? BarrierReason::raw : BarrierReason::waw;
    return event.writes ? BarrierReason::war : BarrierReason::layout;
}

// Returns true if this event and the previous event on the subresource draw to it in the same rendering
// scope. Then no barrier is needed.
bool SingleQueueTracker::merges_render_pass(const AccessEvent& event) const {
    return event.merged_position != kNoId && event.writes && touched_ && !previous_frame_ &&
           position_ == event.merged_position && layout_ == event.state.layout;
}

void SingleQueueTracker::advance(std::span<const AccessEvent> events, CellSync& sync) {
    const AccessEvent& event = events.front();
    if (merges_render_pass(event)) return merge_drawing(event);
    if (needs_barrier(event)) {
        sync.barriers.push_back({.position = event.position,
                                 .src = {pending_stages(), unflushed_, layout_},
                                 .dst = event.writes ? event.state : merge_reads(events),
                                 .reason = reason(event),
                                 .from = pass_,
                                 .previous_frame = previous_frame_});
        apply_barrier(sync.barriers.back());
    }
    apply_event(event);
}

void SingleQueueTracker::release(const AccessState& exit, CellSync& sync) {
    const bool overwritten_next = touched_ && (exit.access & access::kAllWrites) != 0;
    const bool seen = layout_ == exit.layout && (!enters_visible_ || visible(exit));
    if (!written_ && !overwritten_next && seen) return;
    sync.barriers.push_back({.position = kEpiloguePosition,
                             .src = {pending_stages(), unflushed_, layout_},
                             .dst = exit,
                             .reason = BarrierReason::release_import,
                             .from = pass_});
}

void SingleQueueTracker::discard() {
    layout_ = Layout::undefined;
    visible_.fill(access::kNone);
}

void SingleQueueTracker::add_last_uses(std::vector<LastUse>& all) const {
    if (touched_) all.push_back({queue_, position_, pending_stages(), unflushed_, pass_});
}

void SingleQueueTracker::apply_barrier(const CellBarrier& barrier) {
    // If the barrier changes the layout or makes a pending write available, only the accesses in its `dst`
    // see the content from now on.
    if (layout_ != barrier.dst.layout || unflushed_ != 0) visible_.fill(access::kNone);
    for (StageMask left = barrier.dst.stages; left != 0; left &= left - 1)
        visible_[first_stage(left)] |= barrier.dst.access;
    layout_ = barrier.dst.layout;
    unflushed_ = access::kNone;
    reader_stages_ = stage::kNone;
    pass_ = kNoId;
    several_ = false;
    taken_over_ = false;
    entered_ = false;
}

void SingleQueueTracker::apply_event(const AccessEvent& event) {
    note_pass(event.pass);
    touched_ = true;
    previous_frame_ = false;
    queue_ = event.queue;
    position_ = event.position;
    if (!event.writes) {
        reader_stages_ |= event.state.stages;
        return;
    }
    writer_stages_ = event.state.stages;
    unflushed_ = event.state.access & access::kAllWrites;
    reader_stages_ = stage::kNone;
    visible_.fill(access::kNone);
    written_ = true;
}

// The rasteriser keeps the order of draws in a rendering scope. So the next user of the attachment waits for
// both passes if it waits for the later pass.
void SingleQueueTracker::merge_drawing(AccessEvent event) {
    event.state.stages |= writer_stages_;
    event.state.access |= unflushed_;
    pass_ = kNoId;
    several_ = false;
    apply_event(event);
}

void SingleQueueTracker::note_pass(PassId pass) {
    const bool waits_for_outside = entered_ && (reader_stages_ | writer_stages_) != 0;
    several_ = several_ || waits_for_outside || pass == kNoId || (pass_ != kNoId && pass_ != pass);
    pass_ = several_ ? kNoId : pass;
    entered_ = false;
}

}  // namespace weft
