#include "graph/memory/alias_times.h"

#include <algorithm>

namespace weft {

// The clock of a position p is a list with one number per queue. The number for queue q is 1 + the latest
// position on q that surely runs before p. On one queue, these numbers never decrease from one position to
// the next. So the iterator `later` on queue `to` only moves forward while the loop visits the positions `p`
// on queue `from`.
QueueOrder::QueueOrder(const Schedule& order)
    : queue_count_(order.queues.size()), after_(order.queue.size() * queue_count_, 0) {
    std::vector<std::vector<Position>> on_queue(queue_count_);
    for (Position p(0); p < order.queue.size(); ++p) on_queue[order.queue[p]].push_back(p);
    for (size_t to = 0; to < queue_count_; ++to) {
        const uint32_t end = on_queue[to].empty() ? 0 : on_queue[to].back() + 1;
        for (size_t from = 0; from < queue_count_; ++from) {
            auto later = on_queue[to].begin();
            for (const Position p : on_queue[from]) {
                while (later != on_queue[to].end() && order.clocks[*later][from] <= p) ++later;
                after_[p * queue_count_ + to] = later == on_queue[to].end() ? end : uint32_t{*later};
            }
        }
    }
}

QueueTimes QueueOrder::times(const std::vector<ResourceId>& resources, const Lifetimes& spans) const {
    QueueTimes times{queue_count_, std::vector<uint32_t>(resources.size() * queue_count_, UINT32_MAX),
                     std::vector<uint32_t>(resources.size() * queue_count_, 0)};
    for (size_t i = 0; i < resources.size(); ++i) {
        for (const QueueSpan& span : spans.spans[resources[i]].queues) {
            times.begins[i * queue_count_ + span.queue] = span.first;
            for (size_t q = 0; q < queue_count_; ++q) {
                uint32_t& end = times.ends[i * queue_count_ + q];
                end = std::max(end, after_[span.last * queue_count_ + q]);
            }
        }
    }
    return times;
}

}  // namespace weft
