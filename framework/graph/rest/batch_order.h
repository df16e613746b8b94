// Purpose: computes what each batch of a frame waits for if some batches are not submitted, because all their
// passes rest. The other batches run in the same order as if every batch were submitted, and the batches
// whose passes rest contained no commands. Let B be a batch that is not submitted. The next batch on the
// queue of B also waits for everything for which B would wait. A batch on another queue that would wait for B
// waits for the same, and for the batch before B on the queue of B. Between two frames, the program may use
// resources. So a batch that waits for the end of the previous frame for this reason also waits for the work
// that the program has submitted since then. Call the functions for each batch in submission order.
#pragma once

#include <cstdint>
#include <vector>

#include "weft/plan.h"

namespace weft {

// A point on the timeline of a queue: the end of a batch. The values are those of Batch in plan.h. If `queue`
// is equal to the number of queues, the point is on the timeline of the program: the value f means that all
// work has finished that the program submitted to queue 0 before frame f.
struct QueuePoint {
    QueueIndex queue = kGraphicsQueue;
    uint64_t value = 0;
    bool operator==(const QueuePoint&) const = default;
};

class BatchOrder {
 public:
    BatchOrder() = default;
    explicit BatchOrder(const FramePlan& plan);

    // Returns true if batches of the plan wait for work that the program submits between two frames.
    [[nodiscard]] bool awaits_program() const;
    // Returns the point that the batch reaches when it has finished.
    [[nodiscard]] QueuePoint end_of(uint32_t batch, uint64_t frame) const;
    // Begins the next frame.
    void begin_frame();
    // Notes that the batch is submitted, and returns the points that it must wait for: at most one for each
    // queue and one for the program. A point may be on the batch's own queue: instead of a skipped batch
    // of another queue, the batch waits for the points for which the skipped batch would wait.
    [[nodiscard]] std::vector<QueuePoint> submit(uint32_t batch, uint64_t frame);
    // Notes that the batch is not submitted.
    void skip(uint32_t batch);

 private:
    // Index: queue; the last index is the program. Value: the highest value to wait for; 0: no wait.
    using Values = std::vector<uint64_t>;
    struct Place {
        QueueIndex queue = kGraphicsQueue;
        uint64_t rank = 0;  // Number of batches before this one on its queue in a frame.
        std::vector<QueueWait> waits;
        bool awaits_program = false;
    };
    [[nodiscard]] Values waits_of(uint32_t batch) const;
    static void include(const Values& from, Values& into);

    std::vector<Place> batches_;
    uint64_t frames_ = 0;           // Number of frames that have begun.
    std::vector<uint64_t> counts_;  // Index: queue. Number of batches in a frame.
    std::vector<Values> pending_;  // Index: queue. Waits of skipped batches that the next batch must include.
    // Index: queue. The points after which the last batch of the queue, submitted or not, has finished.
    std::vector<Values> queue_ends_;
    // Index: batch. The points after which the batch has finished, for the batches of this frame and of the
    // previous frame.
    std::vector<Values> ends_, previous_ends_;
};

// A unit is a set of passes with "rest", or a round of a group. Returns true if nothing of the batch is
// recorded in a frame in which the units in `resting` rest. Index of `resting`: unit; 1: the unit rests.
[[nodiscard]] bool is_empty_batch(const FramePlan& plan, const Batch& batch,
                                  const std::vector<uint8_t>& resting);

}  // namespace weft
