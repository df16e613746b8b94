#include "graph/sync/barrier_state.h"

namespace weft {

AccessState merged_reads(std::span<const Touch> touches) {
    AccessState state = touches.front().state;
    for (const Touch& touch : touches) {
        if (touch.writes || touch.state.layout != state.layout) break;
        if (touch.queue != touches.front().queue) continue;
        state.stages |= touch.state.stages;
        state.access |= touch.state.access;
    }
    return state;
}

SubresourceState::SubresourceState(const AccessState& entry)
    : taken_over_(false), entered_(true), layout_(entry.layout) {
    unflushed_ = entry.access & access::kAllWrites;
    if (unflushed_ != 0) {
        writer_stages_ = entry.stages;
        return;
    }
    reader_stages_ = entry.stages;
    visible_.fill(~access::kNone);  // nobody has written: there is nothing to make visible
}

bool SubresourceState::visible(const AccessState& state) const {
    for (int s = 0; s < stage::kCount; ++s)
        if ((state.stages & (1u << s)) && (state.access & ~visible_[static_cast<size_t>(s)])) return false;
    return true;
}

bool SubresourceState::needs_barrier(const Touch& touch) const {
    if (taken_over_ || layout_ != touch.state.layout || unflushed_ != 0) return true;
    if (touch.writes) return (reader_stages_ | writer_stages_) != 0;
    return !visible(touch.state);
}

BarrierReason SubresourceState::reason(const Touch& touch) const {
    if (taken_over_) return BarrierReason::hand_over;
    if (entered_) return BarrierReason::acquire_import;
    if (unflushed_ != 0) return touch.reads ? BarrierReason::raw : BarrierReason::waw;
    return touch.writes ? BarrierReason::war : BarrierReason::layout;
}

// Whether the last touch drew to it in the same rendering scope.
bool SubresourceState::goes_on_drawing(const Touch& touch) const {
    return touch.continues != kNoId && touch.writes && touched_ && !previous_frame_ &&
           position_ == touch.continues && layout_ == touch.state.layout;
}

void SubresourceState::advance(std::span<const Touch> touches, CellEvents& events) {
    const Touch& touch = touches.front();
    if (goes_on_drawing(touch)) return join_drawing(touch);
    if (needs_barrier(touch)) {
        events.barriers.push_back({.position = touch.position,
                                   .src = {pending_stages(), unflushed_, layout_},
                                   .dst = touch.writes ? touch.state : merged_reads(touches),
                                   .reason = reason(touch),
                                   .from = pass_,
                                   .previous_frame = previous_frame_});
        apply_barrier(events.barriers.back());
    }
    apply_touch(touch);
}

void SubresourceState::release(const AccessState& exit, CellEvents& events) {
    const bool overwritten_next = touched_ && (exit.access & access::kAllWrites) != 0;
    if (!written_ && !overwritten_next && layout_ == exit.layout) return;
    events.barriers.push_back({.position = kEpiloguePosition,
                               .src = {pending_stages(), unflushed_, layout_},
                               .dst = exit,
                               .reason = BarrierReason::release_import,
                               .from = pass_});
}

void SubresourceState::discard() {
    layout_ = Layout::undefined;
    visible_.fill(access::kNone);
}

void SubresourceState::add_last_uses(std::vector<LastUse>& all) const {
    if (touched_) all.push_back({queue_, position_, pending_stages(), unflushed_, pass_});
}

void SubresourceState::apply_barrier(const CellBarrier& barrier) {
    // A layout change rewrites the memory: what was visible is not any more.
    if (layout_ != barrier.dst.layout || unflushed_ != 0) visible_.fill(access::kNone);
    for (int s = 0; s < stage::kCount; ++s)
        if (barrier.dst.stages & (1u << s)) visible_[static_cast<size_t>(s)] |= barrier.dst.access;
    layout_ = barrier.dst.layout;
    unflushed_ = access::kNone;
    reader_stages_ = stage::kNone;
    pass_ = kNoId;
    several_ = false;
    taken_over_ = false;
    entered_ = false;
}

void SubresourceState::apply_touch(const Touch& touch) {
    note_pass(touch.pass);
    touched_ = true;
    previous_frame_ = false;
    queue_ = touch.queue;
    position_ = touch.position;
    if (!touch.writes) {
        reader_stages_ |= touch.state.stages;
        return;
    }
    writer_stages_ = touch.state.stages;
    unflushed_ = touch.state.access & access::kAllWrites;
    reader_stages_ = stage::kNone;
    visible_.fill(access::kNone);
    written_ = true;
}

// The rasteriser keeps the order: whoever comes next waits for both, by waiting for the later one.
void SubresourceState::join_drawing(Touch touch) {
    touch.state.stages |= writer_stages_;
    touch.state.access |= unflushed_;
    pass_ = kNoId;
    several_ = false;
    apply_touch(touch);
}

void SubresourceState::note_pass(PassId pass) {
    const bool waits_for_outside = entered_ && (reader_stages_ | writer_stages_) != 0;
    several_ = several_ || waits_for_outside || (pass_ != kNoId && pass_ != pass);
    pass_ = several_ ? kNoId : pass;
    entered_ = false;
}

}  // namespace weft
