// Purpose: computes the lifetimes of resources for packing. If the frame uses several queues, a lifetime ends
// only when all queues are surely done with the resource.
#pragma once

#include <vector>

#include "graph/memory/alias_item.h"
#include "weft/plan.h"

namespace weft {

// Finds, for each position p and each queue, the first position on this queue that surely runs after p.
class QueueOrder {
 public:
    explicit QueueOrder(const Schedule& order);

    // Returns the lifetimes of the resources for each queue.
    [[nodiscard]] QueueTimes times(const std::vector<ResourceId>& resources, const Lifetimes& spans) const;

 private:
    size_t queue_count_;
    // Index: position × queue_count_ + queue. The first position on the queue that surely runs after the
    // position. If there is none: 1 + the last position on the queue, or 0 if no pass runs on the queue.
    std::vector<uint32_t> after_;
};

}  // namespace weft
