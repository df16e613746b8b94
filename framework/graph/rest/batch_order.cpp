#include "graph/rest/batch_order.h"

#include <algorithm>
#include <utility>

namespace weft {

namespace {

// Returns true if the wait is for the end of the previous frame. The program may use resources between that
// end and this frame.
bool is_for_program(const FramePlan& plan, const QueueWait& wait) {
    return wait.previous_frame && wait.dependency < plan.submissions.dependencies.size() &&
           plan.submissions.dependencies[wait.dependency].from == plan.schedule.order.size();
}

}  // namespace

BatchOrder::BatchOrder(const FramePlan& plan)
    : counts_(plan.schedule.queues.size(), 0),
      pending_(counts_.size(), Values(counts_.size() + 1, 0)),
      queue_ends_(pending_) {
    for (const Batch& batch : plan.submissions.batches) {
        const bool awaits = std::ranges::any_of(
            batch.waits, [&](const QueueWait& wait) { return is_for_program(plan, wait); });
        batches_.push_back({batch.queue, counts_[batch.queue]++, batch.waits, awaits});
    }
    ends_.assign(batches_.size(), Values(counts_.size() + 1, 0));
    previous_ends_ = ends_;
}

bool BatchOrder::awaits_program() const {
    return std::ranges::any_of(batches_, &Place::awaits_program);
}

QueuePoint BatchOrder::end_of(uint32_t batch, uint64_t frame) const {
    const Place& place = batches_[batch];
    return {place.queue, frame * counts_[place.queue] + place.rank + 1};
}

void BatchOrder::begin_frame() {
    std::swap(ends_, previous_ends_);
    ++frames_;
}

BatchOrder::Values BatchOrder::waits_of(uint32_t batch) const {
    const Place& place = batches_[batch];
    Values values = pending_[place.queue];
    for (const QueueWait& wait : place.waits)
        include(wait.previous_frame ? previous_ends_[wait.batch] : ends_[wait.batch], values);
    if (place.awaits_program) values.back() = frames_ - 1;
    return values;
}

void BatchOrder::include(const Values& from, Values& into) {
    for (size_t queue = 0; queue < into.size(); ++queue) into[queue] = std::max(into[queue], from[queue]);
}

std::vector<QueuePoint> BatchOrder::submit(uint32_t batch, uint64_t frame) {
    const QueueIndex own = batches_[batch].queue;
    const Values waits = waits_of(batch);
    std::vector<QueuePoint> points;
    for (QueueIndex queue(0); queue < waits.size(); ++queue)
        if (waits[queue] > 0) points.push_back({queue, waits[queue]});
    pending_[own].assign(counts_.size() + 1, 0);
    queue_ends_[own].assign(counts_.size() + 1, 0);
    queue_ends_[own][own] = end_of(batch, frame).value;
    ends_[batch] = queue_ends_[own];
    return points;
}

void BatchOrder::skip(uint32_t batch) {
    const QueueIndex own = batches_[batch].queue;
    pending_[own] = waits_of(batch);
    include(pending_[own], queue_ends_[own]);
    ends_[batch] = queue_ends_[own];
}

bool is_empty_batch(const FramePlan& plan, const Batch& batch, const std::vector<uint8_t>& resting) {
    const auto is_left_out = [](const BarrierDecl& barrier) { return barrier.if_pass_runs; };
    return !batch.epilogue && std::ranges::all_of(batch.positions, [&](Position position) {
        const PassStep& step = plan.barriers.steps[position];
        const uint32_t unit = plan.graph.passes[step.pass].rest_unit;
        return unit < resting.size() && resting[unit] != 0 &&
               std::ranges::all_of(step.barriers, is_left_out) &&
               std::ranges::all_of(step.after, is_left_out);
    });
}

}  // namespace weft
