// Purpose: the timeline semaphores of a plan (one per logical queue, one for the prologue of frame 0, and one
// for the program's work between two frames), and the values that each batch waits for and signals. A batch
// is one submission of a frame to a queue. A plan with only one batch needs no semaphores. Frames count from
// 0. Errors: V418 (a semaphore could not be created).
#pragma once

#include <vector>

#include "graph/rest/batch_order.h"
#include "vulkan/device/handle.h"
#include "weft/plan.h"
#include "weft/result.h"

namespace weft::vk {

// A point on the timeline of one queue. It is reached when the value of `semaphore` is at least `value`.
struct TimelinePoint {
    VkSemaphore semaphore = VK_NULL_HANDLE;
    uint64_t value = 0;
};

class QueueTimelines {
 public:
    [[nodiscard]] static Result<QueueTimelines> create(Device& device, const FramePlan& plan);

    [[nodiscard]] bool in_use() const { return !semaphores_.empty(); }
    // Returns the point that a batch signals when it has finished.
    [[nodiscard]] TimelinePoint end_of(uint32_t batch, uint64_t frame) const;
    // Begins the next frame. Then, for each batch in submission order, call submit() or skip().
    void begin_frame() { order_.begin_frame(); }
    // Returns the points that the batch waits for: the ends of other batches of the same frame or of the
    // previous frame. In frame 0, every batch also waits for all earlier work of queue 0: the prologue, and
    // uploads to imports.
    [[nodiscard]] std::vector<TimelinePoint> submit(uint32_t batch, uint64_t frame);
    // Leaves out a batch in which nothing is recorded.
    void skip(uint32_t batch) { order_.skip(batch); }
    // Returns the point that queue 0 signals before frame 0, after the prologue has initialised persistent
    // resources.
    [[nodiscard]] TimelinePoint ready() const { return {ready_.get(), 1}; }
    // Returns true if batches of each frame wait for what the program has submitted since the previous frame.
    [[nodiscard]] bool awaits_program() const { return program_.get() != VK_NULL_HANDLE; }
    // Returns the point that queue 0 signals before the batches of a frame, after the work of the program.
    [[nodiscard]] TimelinePoint program_done(uint64_t frame) const { return {program_.get(), frame}; }
    // Returns a new point. It is signalled when the program has signalled its semaphores, and the batches of
    // a frame wait for this point instead of the semaphores.
    [[nodiscard]] TimelinePoint next_gate() { return {gate_.get(), ++gate_value_}; }

 private:
    // One timeline semaphore for each logical queue.
    std::vector<SemaphoreHandle> semaphores_;
    BatchOrder order_;
    SemaphoreHandle ready_;
    SemaphoreHandle program_;  // Null if no batch waits for the program.
    SemaphoreHandle gate_;
    uint64_t gate_value_ = 0;
};

}  // namespace weft::vk
