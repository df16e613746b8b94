// Purpose: manages the frames in flight: command buffers for the batches of each frame, their submission, and
// the check whether a frame has finished. Errors: V418; the executor converts time-outs to V407 and a lost
// device to V408.
#pragma once

#include <array>

#include "vulkan/device/handle.h"
#include "vulkan/device/plan_queues.h"
#include "vulkan/execute/queue_timelines.h"
#include "weft/vulkan/executor.h"

namespace weft::vk {

// The command buffer and queue of one batch.
struct BatchCommands {
    VkCommandBuffer commands = VK_NULL_HANDLE;
    bool labels = false;  // the queue supports debug labels
};

class FrameSlots {
 public:
    [[nodiscard]] static Result<FrameSlots> create(Device& device, const FramePlan& plan);

    [[nodiscard]] bool in_flight(uint32_t slot) const { return slots_[slot].in_flight; }
    // Returns VK_SUCCESS immediately if nothing is in flight.
    [[nodiscard]] VkResult wait(uint32_t slot);
    // Call this after all frames have finished and before the semaphores are destroyed, unless something else
    // was submitted to their queues since: lavapipe (Mesa 22.3) signals the end of a submission slightly
    // before it releases the semaphores.
    void let_go() const;
    // Does not wait. On a lost device the result is always true.
    [[nodiscard]] bool is_over(uint32_t slot) const;

    // Resets the slot for frame `frame`; commands are recorded between begin() and submit().
    [[nodiscard]] Status begin(uint32_t slot, uint64_t frame);
    [[nodiscard]] BatchCommands batch(uint32_t slot, uint32_t batch) const;
    // Used in frame 0 only: runs before all batches, on the first queue.
    [[nodiscard]] VkCommandBuffer prologue(uint32_t slot) const { return slots_[slot].prologue; }
    // Submits the batches in order. After an error, part of the frame may be in flight.
    [[nodiscard]] VkResult submit(uint32_t slot, uint64_t frame);

 private:
    struct Slot {
        std::vector<CommandPoolHandle> pools;   // index: queue
        std::vector<VkCommandBuffer> commands;  // index: batch
        VkCommandBuffer prologue = VK_NULL_HANDLE;
        FenceHandle fence;                // for a frame of one batch
        std::vector<TimelinePoint> last;  // for a frame of several batches: the end of the last batch on each
                                          // queue
        bool in_flight = false;
    };
    [[nodiscard]] VkResult open(Slot& slot) const;
    [[nodiscard]] VkResult allocate(VkCommandPool pool, VkCommandBuffer& commands) const;
    [[nodiscard]] VkResult submit_alone(Slot& slot, uint64_t frame) const;
    [[nodiscard]] VkResult submit_batches(Slot& slot, uint64_t frame) const;

    Device* device_ = nullptr;
    std::vector<PlanQueue> queues_;
    std::vector<QueueIndex> queue_of_;  // index: batch
    QueueTimelines timelines_;
    std::array<Slot, kFramesInFlight> slots_;
    bool submitted_ = false;  // true after the first submission
};

}  // namespace weft::vk
