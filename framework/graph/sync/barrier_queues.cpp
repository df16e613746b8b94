#include "graph/sync/barrier_queues.h"

#include <algorithm>

namespace weft {
namespace {

// The reads that share one layout from the first touch on, or the one write.
std::span<const Touch> group_of(std::span<const Touch> touches) {
    size_t count = 1;
    if (!touches.front().writes)
        while (count < touches.size() && !touches[count].writes &&
               touches[count].state.layout == touches.front().state.layout)
            ++count;
    return touches.first(count);
}

bool on_several_queues(std::span<const Touch> group) {
    return std::any_of(group.begin(), group.end(),
                       [&](const Touch& t) { return t.queue != group.front().queue; });
}

// What the group does on one queue.
AccessState state_on(std::span<const Touch> group, QueueIndex queue) {
    AccessState state{stage::kNone, access::kNone, group.front().state.layout};
    for (const Touch& touch : group) {
        if (touch.queue != queue) continue;
        state.stages |= touch.state.stages;
        state.access |= touch.state.access;
    }
    return state;
}

}  // namespace

QueueWalk::QueueWalk(const QueueRules& rules, const AccessState& entry, bool changes)
    : rules_(&rules), entered_(true), layout_(entry.layout) {
    if (changes) source_ = Past{rules.epilogue, 0, entry.stages, kNoId, true};
    source_writes_ = unflushed_ = entry.access & access::kAllWrites;
    if (unflushed_ == 0) visible_.fill(~access::kNone);
}

bool QueueWalk::visible(const AccessState& state) const {
    for (int s = 0; s < stage::kCount; ++s)
        if ((state.stages & (1u << s)) && (state.access & ~visible_[static_cast<size_t>(s)])) return false;
    return true;
}

bool QueueWalk::starts_anew(const Touch& touch) const {
    if (taken_over_ || touch.writes) return true;
    if (rules_->image && layout_ != touch.state.layout) return true;
    return rules_->exclusive && touched_ && family(touch.queue) != owner_family_;
}

// Those that have to be over before the next change. Readers come after the source.
std::vector<QueueWalk::Past> QueueWalk::predecessors() const {
    if (!readers_.empty()) return readers_;
    if (source_) return {*source_};
    return {};
}

void QueueWalk::wait_for(const Past& past, uint32_t position, CellEvents& events) const {
    events.dependencies.push_back({past.position, position, past.previous_frame, rules_->resource});
}

BarrierReason QueueWalk::reason(const Touch& touch) const {
    if (taken_over_) return BarrierReason::hand_over;
    if (entered_) return BarrierReason::acquire_import;
    if (readers_.empty()) return touch.reads ? BarrierReason::raw : BarrierReason::waw;
    return touch.writes ? BarrierReason::war : BarrierReason::layout;
}

void QueueWalk::advance(std::span<const Touch> touches, CellEvents& events) {
    if (goes_on_drawing(touches.front()))
        join_drawing(touches.front());
    else if (starts_anew(touches.front()))
        begin(touches, events);
    else
        join(touches, events);
    taken_over_ = false;
    entered_ = false;
    touched_ = true;
    owner_family_ = family(touches.front().queue);
}

// Whether the last touch drew to it in the same rendering scope.
bool QueueWalk::goes_on_drawing(const Touch& touch) const {
    return touch.continues != kNoId && touch.writes && source_ && !source_->previous_frame &&
           source_->position == touch.continues && readers_.empty() && layout_ == touch.state.layout;
}

// The rasteriser keeps the order: whoever comes next waits for both, by waiting for the later one.
void QueueWalk::join_drawing(const Touch& touch) {
    source_ = Past{touch.position, touch.queue, source_->stages | touch.state.stages, touch.pass, false};
    source_writes_ |= touch.state.access & access::kAllWrites;
    unflushed_ |= source_writes_;
}

// One more reader of what is there already.
void QueueWalk::join(std::span<const Touch> touches, CellEvents& events) {
    const Touch& touch = touches.front();
    if (source_ && source_->queue != touch.queue) {
        wait_for(*source_, touch.position, events);
    } else if (source_ && (unflushed_ != 0 || !visible(touch.state))) {
        const AccessState dst = state_on(group_of(touches), touch.queue);
        events.barriers.push_back({.position = touch.position,
                                   .src = {source_->stages, source_writes_, layout_},
                                   .dst = dst,
                                   .reason = reason(touch),
                                   .from = source_->pass,
                                   .previous_frame = source_->previous_frame});
        unflushed_ = access::kNone;
        for (int s = 0; s < stage::kCount; ++s)
            if (dst.stages & (1u << s)) visible_[static_cast<size_t>(s)] |= dst.access;
    }
    readers_.push_back({touch.position, touch.queue, touch.state.stages, touch.pass, false});
}

// The predecessor after which a transition for readers on several queues can be recorded, so that none of
// them has to wait for another.
std::optional<QueueWalk::Past> QueueWalk::common_past(std::span<const Touch> touches) const {
    const std::span<const Touch> group = group_of(touches);
    if (taken_over_ || entered_ || touches.front().writes || !on_several_queues(group)) return {};
    const std::vector<Past> all = predecessors();
    const bool usable = !all.empty() && std::all_of(all.begin(), all.end(), [&](const Past& p) {
        return p.queue == all.front().queue && !p.previous_frame;
    });
    if (!usable) return {};
    Past past = all.back();
    for (const Past& p : all) past.stages |= p.stages;
    return past;
}

void QueueWalk::begin(std::span<const Touch> touches, CellEvents& events) {
    const bool moves =
        rules_->exclusive && touched_ && !taken_over_ && family(touches.front().queue) != owner_family_;
    if (moves) return transfer(touches, events);
    if (const std::optional<Past> past = common_past(touches)) return share(*past, touches, events);
    change(touches, events);
}

void QueueWalk::share(const Past& past, std::span<const Touch> touches, CellEvents& events) {
    const Touch& touch = touches.front();
    AccessState dst = state_on(group_of(touches), past.queue);
    // Later barriers on this queue chain to the transition through the stages it holds back.
    if (dst.stages == stage::kNone) dst.stages = past.stages;
    events.barriers.push_back({.position = past.position,
                               .after = true,
                               .src = {past.stages, unflushed_on(past.queue), layout_},
                               .dst = dst,
                               .reason = reason(touch),
                               .from = past.pass});
    layout_ = dst.layout;
    unflushed_ = source_writes_ = access::kNone;
    visible_.fill(access::kNone);
    for (int s = 0; s < stage::kCount; ++s)
        if (dst.stages & (1u << s)) visible_[static_cast<size_t>(s)] = dst.access;
    source_ = past;
    source_->stages = dst.stages;
    readers_.clear();
    join(touches, events);
}

// From one queue family to another, in order: released after the last use, acquired before the next.
void QueueWalk::transfer(std::span<const Touch> touches, CellEvents& events) {
    const Touch& touch = touches.front();
    const std::vector<Past> all = predecessors();
    const Past last = *std::max_element(all.begin(), all.end(),
                                        [](const Past& a, const Past& b) { return a.position < b.position; });
    AccessState src{stage::kNone, unflushed_on(last.queue), layout_};
    for (const Past& past : all) {
        if (past.queue == last.queue)
            src.stages |= past.stages;
        else
            wait_for(past, last.position, events);
    }
    const AccessState dst = touch.writes ? touch.state : state_on(group_of(touches), touch.queue);
    CellBarrier release{.position = last.position,
                        .after = true,
                        .src = src,
                        .dst = {stage::kNone, access::kNone, dst.layout},
                        .reason = BarrierReason::release_queue,
                        .from = last.pass};
    release.src_family = owner_family_;
    release.dst_family = family(touch.queue);
    CellBarrier acquire = release;
    acquire.position = touch.position;
    acquire.after = false;
    acquire.src = {dst.stages, access::kNone, layout_};
    acquire.dst = dst;
    acquire.reason = BarrierReason::acquire_queue;
    acquire.pair_position = last.position;
    acquire.pair_state = src;
    release.pair_position = touch.position;
    release.pair_state = dst;
    events.barriers.push_back(release);
    events.barriers.push_back(acquire);
    wait_for(last, touch.position, events);
    note_source(touch, dst);
}

void QueueWalk::change(std::span<const Touch> touches, CellEvents& events) {
    const Touch& touch = touches.front();
    AccessState src{stage::kNone, access::kNone, layout_};
    bool elsewhere = false, previous = true;
    PassId from = kNoId;
    for (const Past& past : predecessors()) {
        previous = previous && past.previous_frame;
        if (past.queue != touch.queue) {
            wait_for(past, touch.position, events);
            elsewhere = true;
            continue;
        }
        from = src.stages == stage::kNone ? past.pass : kNoId;
        src.stages |= past.stages;
    }
    if (unflushed_on(touch.queue) != 0) {
        src.stages |= source_->stages;
        src.access = unflushed_;
    }
    const AccessState dst = touch.writes ? touch.state : state_on(group_of(touches), touch.queue);
    const bool new_layout = rules_->image && layout_ != dst.layout;
    if (new_layout && elsewhere) src.stages |= dst.stages;  // chains with the semaphore's wait
    if (taken_over_ || new_layout || src.stages != stage::kNone)
        events.barriers.push_back({.position = touch.position,
                                   .src = src,
                                   .dst = dst,
                                   .reason = reason(touch),
                                   .from = from,
                                   .previous_frame = previous && !taken_over_});
    note_source(touch, dst);
}

void QueueWalk::note_source(const Touch& touch, const AccessState& made_visible) {
    source_ = Past{touch.position, touch.queue, touch.state.stages, touch.pass, false};
    readers_.clear();
    layout_ = made_visible.layout;
    source_writes_ = touch.writes ? touch.state.access & access::kAllWrites : access::kNone;
    unflushed_ = source_writes_;
    visible_.fill(access::kNone);
    written_ = written_ || touch.writes;
    if (touch.writes) return;
    for (int s = 0; s < stage::kCount; ++s)
        if (made_visible.stages & (1u << s)) visible_[static_cast<size_t>(s)] = made_visible.access;
    readers_.push_back(*source_);
}

void QueueWalk::release(const AccessState& exit, CellEvents& events) {
    const bool overwritten_next = touched_ && (exit.access & access::kAllWrites) != 0;
    if (!written_ && !overwritten_next && layout_ == exit.layout) return;
    AccessState src{stage::kNone, access::kNone, layout_};
    for (const Past& past : predecessors()) {
        if (past.queue == 0)
            src.stages |= past.stages;
        else
            wait_for(past, rules_->epilogue, events);
    }
    src.access = unflushed_on(0);
    if (src.stages == stage::kNone) src.stages = exit.stages;
    events.barriers.push_back(
        {.position = kEpiloguePosition, .src = src, .dst = exit, .reason = BarrierReason::release_import});
}

void QueueWalk::next_frame() {
    if (source_) source_->previous_frame = true;
    for (Past& reader : readers_) reader.previous_frame = true;
}

void QueueWalk::discard() {
    layout_ = Layout::undefined;
    visible_.fill(access::kNone);
}

void QueueWalk::add_last_uses(std::vector<LastUse>& all) const {
    for (const Past& past : predecessors())
        if (touched_) all.push_back({past.queue, past.position, past.stages, access::kNone, past.pass});
    if (touched_ && source_ && unflushed_ != 0)
        all.push_back({source_->queue, source_->position, source_->stages, unflushed_, source_->pass});
}

}  // namespace weft
