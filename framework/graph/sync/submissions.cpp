// Divides the passes of each queue into batches, one submission each. A new batch begins before every pass
// that waits for another queue. A batch ends after every pass that another queue waits for.

#include "graph/sync/submissions.h"
#include "graph/sync/queue_clocks.h"

namespace weft {
namespace {

constexpr uint32_t kNoBatch = UINT32_MAX;

// Builds the batches. The end of the frame, where imports get their exit states, is treated as one more
// position after the last pass, on queue 0.
class Batches {
 public:
    Batches(const Schedule& order, const std::vector<Wait>& waits) : order_(order), waits_(waits) {
        const size_t points = order.order.size() + 1;
        waiting_.assign(points, 0);
        awaited_.assign(points, 0);
        for (const Wait& wait : waits) {
            waiting_[wait.position] = 1;
            awaited_[wait.dependency.from] = 1;
        }
        open_.assign(order.queues.size(), kNoBatch);
        batch_of_.assign(points, kNoBatch);
    }

    std::vector<Batch> make() {
        const Position end(order_.order.size());
        for (Position position(0); position < end; ++position) {
            Batch& batch = batch_for(position, order_.queue[position]);
            batch.positions.push_back(position);
        }
        batch_for(end, kGraphicsQueue).epilogue = true;
        for (uint32_t i = 0; i < waits_.size(); ++i) {
            const QueueDependency& d = waits_[i].dependency;
            batches_[batch_of_[waits_[i].position]].waits.push_back({batch_of_[d.from], d.previous_frame, i});
        }
        return std::move(batches_);
    }

 private:
    Batch& batch_for(Position position, QueueIndex queue) {
        if (open_[queue] == kNoBatch || waiting_[position] != 0) {
            open_[queue] = static_cast<uint32_t>(batches_.size());
            batches_.emplace_back().queue = queue;
        }
        batch_of_[position] = open_[queue];
        Batch& batch = batches_[open_[queue]];
        if (awaited_[position] != 0) open_[queue] = kNoBatch;
        return batch;
    }

    const Schedule& order_;
    const std::vector<Wait>& waits_;
    // Index: position. waiting_: 1 if the position waits for another queue. awaited_: 1 if another queue
    // waits for the position.
    std::vector<uint8_t> waiting_, awaited_;
    // Index: queue. The batch that gets the queue's next pass; kNoBatch if a new batch must begin.
    std::vector<uint32_t> open_;
    std::vector<uint32_t> batch_of_;  // Index: position. Index of the batch that has the pass.
    std::vector<Batch> batches_;      // All batches, sorted by the position of their first pass.
};

}  // namespace

SubmissionPlan submissions(const Schedule& order, const std::vector<QueueDependency>& dependencies) {
    std::vector<QueueIndex> queue = order.queue;
    queue.push_back(kGraphicsQueue);
    const std::vector<Wait> waits = minimal_waits(queue, order.queues.size(), dependencies);
    SubmissionPlan plan;
    for (const Wait& wait : waits) plan.dependencies.push_back(wait.dependency);
    plan.batches = Batches(order, waits).make();
    return plan;
}

}  // namespace weft
