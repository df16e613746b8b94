#include "graph/sync/multi_queue_tracker.h"

#include <algorithm>

namespace weft {
namespace {

// Returns those accesses at the start of the list that one barrier can cover: a single write, or consecutive
// reads in the same layout.
std::span<const AccessEvent> group_of(std::span<const AccessEvent> events) {
    size_t count = 1;
    if (!events.front().writes)
        while (count < events.size() && !events[count].writes &&
               events[count].state.layout == events.front().state.layout)
            ++count;
    return events.first(count);
}

bool on_several_queues(std::span<const AccessEvent> group) {
    return std::any_of(group.begin(), group.end(),
                       [&](const AccessEvent& t) { return t.queue != group.front().queue; });
}

// Returns the union of the stages and access types of those events of the group that run on this queue.
AccessState state_on(std::span<const AccessEvent> group, QueueIndex queue) {
    AccessState state{stage::kNone, access::kNone, group.front().state.layout};
    for (const AccessEvent& event : group) {
        if (event.queue != queue) continue;
        state.stages |= event.state.stages;
        state.access |= event.state.access;
    }
    return state;
}

}  // namespace

bool changes_import(const ImportState& import, std::span<const AccessEvent> events) {
    const bool pending = ((import.entry.access | import.exit.access) & access::kAllWrites) != 0;
    return pending || import.entry.layout != import.exit.layout ||
           std::ranges::any_of(events, [&](const AccessEvent& event) {
               return event.writes || event.state.layout != import.entry.layout;
           });
}

MultiQueueTracker::MultiQueueTracker(const QueueRules& rules, const AccessState& entry, bool changes)
    : rules_(&rules), entered_(true), layout_(entry.layout) {
    if (changes) source_ = Past{rules.epilogue, kGraphicsQueue, entry.stages, kNoId, true};
    source_writes_ = unflushed_ = entry.access & access::kAllWrites;
    if (unflushed_ != 0) return;
    visible_.fill(~access::kNone);
    enters_visible_ = true;
    // The program may still read the import. A later write or layout change must wait for this read, even if
    // passes of this frame read the import first.
    if (source_ && entry.stages != stage::kNone) readers_.push_back(*source_);
}

bool MultiQueueTracker::visible(const AccessState& state) const {
    for (int s = 0; s < stage::kCount; ++s)
        if ((state.stages & (1u << s)) && (state.access & ~visible_[static_cast<size_t>(s)])) return false;
    return true;
}

bool MultiQueueTracker::starts_anew(const AccessEvent& event) const {
    if (taken_over_ || event.writes) return true;
    if (rules_->image && layout_ != event.state.layout) return true;
    return rules_->exclusive && touched_ && family(event.queue) != owner_family_;
}

// Returns the earlier uses that must complete before the next write or layout change. These are the readers
// of the current content. If there are no readers, returns the write or layout transition that made the
// content.
std::span<const MultiQueueTracker::Past> MultiQueueTracker::predecessors() const {
    if (!readers_.empty()) return readers_;
    if (source_) return {&*source_, 1};
    return {};
}

void MultiQueueTracker::wait_for(const Past& past, Position position, CellSync& sync) const {
    sync.dependencies.push_back({past.position, position, past.previous_frame, rules_->resource});
}

BarrierReason MultiQueueTracker::reason(const AccessEvent& event) const {
    if (taken_over_) return BarrierReason::alias;
    if (entered_) return BarrierReason::acquire_import;
    if (readers_.empty()) return event.reads ? BarrierReason::raw : BarrierReason::waw;
    return event.writes ? BarrierReason::war : BarrierReason::layout;
}

void MultiQueueTracker::advance(std::span<const AccessEvent> events, CellSync& sync) {
    if (merges_render_pass(events.front()))
        merge_drawing(events.front());
    else if (starts_anew(events.front()))
        begin(events, sync);
    else
        join(events, sync);
    taken_over_ = false;
    entered_ = false;
    touched_ = true;
    owner_family_ = family(events.front().queue);
}

// Returns true if this event and the previous event on the subresource draw to it in the same rendering
// scope. Then no barrier is needed.
bool MultiQueueTracker::merges_render_pass(const AccessEvent& event) const {
    return event.merged_position != kNoId && event.writes && source_ && !source_->previous_frame &&
           source_->position == event.merged_position && readers_.empty() && layout_ == event.state.layout;
}

// The rasteriser keeps the order of draws in a rendering scope. So the next user of the attachment waits for
// both passes if it waits for the later pass.
void MultiQueueTracker::merge_drawing(const AccessEvent& event) {
    source_ = Past{event.position, event.queue, source_->stages | event.state.stages, event.pass, false};
    source_writes_ |= event.state.access & access::kAllWrites;
    unflushed_ |= source_writes_;
}

// Adds a reader of the current content. If another queue made the content, adds a dependency, from which a
// semaphore wait results. If the same queue made the content, and the content is not visible to the reader
// yet, adds a barrier.
void MultiQueueTracker::join(std::span<const AccessEvent> events, CellSync& sync) {
    const AccessEvent& event = events.front();
    if (source_ && source_->queue != event.queue) {
        wait_for(*source_, event.position, sync);
    } else if (source_ && (unflushed_ != 0 || !visible(event.state))) {
        const AccessState dst = state_on(group_of(events), event.queue);
        sync.barriers.push_back({.position = event.position,
                                 .src = {source_->stages, source_writes_, layout_},
                                 .dst = dst,
                                 .reason = reason(event),
                                 .from = source_->pass,
                                 .previous_frame = source_->previous_frame});
        unflushed_ = access::kNone;
        for (int s = 0; s < stage::kCount; ++s)
            if (dst.stages & (1u << s)) visible_[static_cast<size_t>(s)] |= dst.access;
    }
    readers_.push_back({event.position, event.queue, event.state.stages, event.pass, false});
}

// Finds the earlier use after which one layout transition can be recorded for readers on several queues. Then
// each reader waits only for this transition, not for another reader. Returns nothing in all other cases, for
// example if the earlier uses are on different queues or in the previous frame.
std::optional<MultiQueueTracker::Past> MultiQueueTracker::common_past(
    std::span<const AccessEvent> events) const {
    const std::span<const AccessEvent> group = group_of(events);
    if (taken_over_ || entered_ || events.front().writes || !on_several_queues(group)) return {};
    const std::span<const Past> all = predecessors();
    const bool usable = !all.empty() && std::all_of(all.begin(), all.end(), [&](const Past& p) {
        return p.queue == all.front().queue && !p.previous_frame;
    });
    if (!usable) return {};
    Past past = all.back();
    for (const Past& p : all) past.stages |= p.stages;
    return past;
}

void MultiQueueTracker::begin(std::span<const AccessEvent> events, CellSync& sync) {
    const bool moves =
        rules_->exclusive && touched_ && !taken_over_ && family(events.front().queue) != owner_family_;
    if (moves) return transfer(events, sync);
    if (const std::optional<Past> past = common_past(events)) return share(*past, events, sync);
    change(events, sync);
}

void MultiQueueTracker::share(const Past& past, std::span<const AccessEvent> events, CellSync& sync) {
    const AccessEvent& event = events.front();
    AccessState dst = state_on(group_of(events), past.queue);
    // If no reader on this queue uses the transition, the destination stages of its barrier are the same as
    // the source stages. Then later barriers on this queue wait for the transition too.
    if (dst.stages == stage::kNone) dst.stages = past.stages;
    sync.barriers.push_back({.position = past.position,
                             .after = true,
                             .src = {past.stages, unflushed_on(past.queue), layout_},
                             .dst = dst,
                             .reason = reason(event),
                             .from = past.pass});
    layout_ = dst.layout;
    unflushed_ = source_writes_ = access::kNone;
    visible_.fill(access::kNone);
    for (int s = 0; s < stage::kCount; ++s)
        if (dst.stages & (1u << s)) visible_[static_cast<size_t>(s)] = dst.access;
    source_ = past;
    source_->stages = dst.stages;
    readers_.clear();
    join(events, sync);
}

// Moves the subresource from one queue family to another: a release barrier after the last use on the old
// family, and an acquire barrier before the next use on the new family.
void MultiQueueTracker::transfer(std::span<const AccessEvent> events, CellSync& sync) {
    const AccessEvent& event = events.front();
    const std::span<const Past> all = predecessors();
    const Past last = *std::max_element(all.begin(), all.end(),
                                        [](const Past& a, const Past& b) { return a.position < b.position; });
    AccessState src{stage::kNone, unflushed_on(last.queue), layout_};
    for (const Past& past : all) {
        if (past.queue == last.queue)
            src.stages |= past.stages;
        else
            wait_for(past, last.position, sync);
    }
    const AccessState dst = event.writes ? event.state : state_on(group_of(events), event.queue);
    CellBarrier release{.position = last.position,
                        .after = true,
                        .src = src,
                        .dst = {stage::kNone, access::kNone, dst.layout},
                        .reason = BarrierReason::release_queue,
                        .from = last.pass};
    release.src_family = owner_family_;
    release.dst_family = family(event.queue);
    CellBarrier acquire = release;
    acquire.position = event.position;
    acquire.after = false;
    acquire.src = {dst.stages, access::kNone, layout_};
    acquire.dst = dst;
    acquire.reason = BarrierReason::acquire_queue;
    acquire.pair_position = last.position;
    acquire.pair_state = src;
    release.pair_position = event.position;
    release.pair_state = dst;
    sync.barriers.push_back(release);
    sync.barriers.push_back(acquire);
    wait_for(last, event.position, sync);
    note_source(event, dst);
}

void MultiQueueTracker::change(std::span<const AccessEvent> events, CellSync& sync) {
    const AccessEvent& event = events.front();
    AccessState src{stage::kNone, access::kNone, layout_};
    bool elsewhere = false, previous = true;
    PassId from = kNoId;
    for (const Past& past : predecessors()) {
        previous = previous && past.previous_frame;
        if (past.queue != event.queue) {
            wait_for(past, event.position, sync);
            elsewhere = true;
            continue;
        }
        from = src.stages == stage::kNone ? past.pass : kNoId;
        src.stages |= past.stages;
    }
    if (unflushed_on(event.queue) != 0) {
        src.stages |= source_->stages;
        src.access = unflushed_;
    }
    const AccessState dst = event.writes ? event.state : state_on(group_of(events), event.queue);
    const bool new_layout = rules_->image && layout_ != dst.layout;
    // The barrier includes the stages that wait for the semaphore, so that it runs after the semaphore wait.
    if (new_layout && elsewhere) src.stages |= dst.stages;
    if (taken_over_ || new_layout || src.stages != stage::kNone)
        sync.barriers.push_back({.position = event.position,
                                 .src = src,
                                 .dst = dst,
                                 .reason = reason(event),
                                 .from = from,
                                 .previous_frame = previous && !taken_over_});
    note_source(event, dst);
}

void MultiQueueTracker::note_source(const AccessEvent& event, const AccessState& made_visible) {
    source_ = Past{event.position, event.queue, event.state.stages, event.pass, false};
    readers_.clear();
    layout_ = made_visible.layout;
    source_writes_ = event.writes ? event.state.access & access::kAllWrites : access::kNone;
    unflushed_ = source_writes_;
    visible_.fill(access::kNone);
    written_ = written_ || event.writes;
    if (event.writes) return;
    for (int s = 0; s < stage::kCount; ++s)
        if (made_visible.stages & (1u << s)) visible_[static_cast<size_t>(s)] = made_visible.access;
    readers_.push_back(*source_);
}

void MultiQueueTracker::release(const AccessState& exit, CellSync& sync) {
    const bool overwritten_next = touched_ && (exit.access & access::kAllWrites) != 0;
    const bool here = !source_ || source_->queue == kGraphicsQueue;
    const bool seen = layout_ == exit.layout && (!enters_visible_ || (here && visible(exit)));
    if (!written_ && !overwritten_next && seen) return;
    AccessState src{stage::kNone, access::kNone, layout_};
    for (const Past& past : predecessors()) {
        if (past.queue == kGraphicsQueue)
            src.stages |= past.stages;
        else
            wait_for(past, rules_->epilogue, sync);
    }
    src.access = unflushed_on(kGraphicsQueue);
    if (src.stages == stage::kNone) src.stages = exit.stages;
    sync.barriers.push_back(
        {.position = kEpiloguePosition, .src = src, .dst = exit, .reason = BarrierReason::release_import});
}

void MultiQueueTracker::next_frame() {
    if (source_) source_->previous_frame = true;
    for (Past& reader : readers_) reader.previous_frame = true;
}

void MultiQueueTracker::discard() {
    layout_ = Layout::undefined;
    visible_.fill(access::kNone);
}

void MultiQueueTracker::add_last_uses(std::vector<LastUse>& all) const {
    for (const Past& past : predecessors())
        if (touched_) all.push_back({past.queue, past.position, past.stages, access::kNone, past.pass});
    if (touched_ && source_ && unflushed_ != 0)
        all.push_back({source_->queue, source_->position, source_->stages, unflushed_, source_->pass});
}

}  // namespace weft
