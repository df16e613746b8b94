// Purpose: the frames in flight: command buffers for the batches of each, how they are submitted, and how one
// knows that a frame is over. Errors: V418; the executor turns time-outs into V407, a lost device into V408.
#pragma once

#include <array>

#include "vulkan/device/plan_queues.h"
#include "vulkan/execute/queue_timelines.h"
#include "weft/vulkan/executor.h"
#include "weft/vulkan/handle.h"

namespace weft::vk {

// Where one batch is recorded.
struct BatchCommands {
    VkCommandBuffer commands = VK_NULL_HANDLE;
    bool labels = false;  // the queue takes debug labels
};

class FrameSlots {
 public:
    [[nodiscard]] static Result<FrameSlots> create(Device& device, const FramePlan& plan);

    [[nodiscard]] bool in_flight(uint32_t slot) const { return slots_[slot].in_flight; }
    // VK_SUCCESS at once when nothing is in flight.
    [[nodiscard]] VkResult wait(uint32_t slot);
    // Once all frames are over, before the semaphores go, if nothing was submitted to their queues since:
    // lavapipe (Mesa 22.3) signals a submission's end a moment before it lets go of the semaphores.
    void let_go() const;
    // Without waiting. On a lost device everything is.
    [[nodiscard]] bool is_over(uint32_t slot) const;

    // Empties the slot for frame `frame`; everything is recorded between begin() and submit().
    [[nodiscard]] Status begin(uint32_t slot, uint64_t frame);
    [[nodiscard]] BatchCommands batch(uint32_t slot, uint32_t batch) const;
    // Of frame 0 only: executed before all batches, on the first queue.
    [[nodiscard]] VkCommandBuffer prologue(uint32_t slot) const { return slots_[slot].prologue; }
    // Submits the batches in order. An error may leave part of the frame in flight.
    [[nodiscard]] VkResult submit(uint32_t slot, uint64_t frame);

 private:
    struct Slot {
        std::vector<CommandPoolHandle> pools;   // by queue
        std::vector<VkCommandBuffer> commands;  // by batch
        VkCommandBuffer prologue = VK_NULL_HANDLE;
        FenceHandle fence;                // of a frame that is one batch
        std::vector<TimelinePoint> last;  // of one that is several: its last end on each queue
        bool in_flight = false;
    };
    [[nodiscard]] VkResult open(Slot& slot) const;
    [[nodiscard]] VkResult allocate(VkCommandPool pool, VkCommandBuffer& commands) const;
    [[nodiscard]] VkResult submit_alone(Slot& slot, uint64_t frame) const;
    [[nodiscard]] VkResult submit_batches(Slot& slot, uint64_t frame) const;

    Device* device_ = nullptr;
    std::vector<PlanQueue> queues_;
    std::vector<QueueIndex> queue_of_;  // by batch
    QueueTimelines timelines_;
    std::array<Slot, kFramesInFlight> slots_;
    bool submitted_ = false;  // anything, ever
};

}  // namespace weft::vk
