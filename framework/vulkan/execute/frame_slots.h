// Purpose: manages the frame slots of the frames in flight: command buffers for the batches of each frame (a
// batch is one submission to a queue), their submission, and the check whether a frame has finished. Errors:
// V418, except that time-outs, lost devices and exhausted memory have the codes of vk_result.h.
#pragma once

#include <array>

#include "vulkan/device/handle.h"
#include "vulkan/device/plan_queues.h"
#include "vulkan/execute/queue_timelines.h"
#include "weft/vulkan/executor.h"

namespace weft::vk {

// The command buffer of one batch of a frame.
struct BatchCommands {
    VkCommandBuffer commands = VK_NULL_HANDLE;
    // True if the command buffer may contain debug labels, because its queue draws or computes.
    bool labels = false;
    uint32_t family = 0;
};

// The part of a submission that the program chooses. `how` contains the semaphores and the ticket of the
// program. `batches` gives, for each semaphore in FrameSubmit::waits, the batch that waits for it (kNoId: all
// batches wait).
struct ProgramWaits {
    const FrameSubmit& how;
    std::vector<uint32_t> batches;
};

class FrameSlots {
 public:
    [[nodiscard]] static Result<FrameSlots> create(Device& device, const FramePlan& plan);

    [[nodiscard]] bool in_flight(uint32_t slot) const { return slots_[slot].in_flight; }
    // Waits until the frame in `slot` has finished. Returns VK_SUCCESS immediately if no frame is in flight
    // there.
    [[nodiscard]] VkResult wait(uint32_t slot);
    // Waits until the queues are idle. Call this after all frames have finished and before the semaphores are
    // destroyed, because lavapipe (Mesa 22.3) signals the end of a submission slightly before it releases the
    // semaphores. The call is not needed if another executor has replaced this one and submits its frames to
    // the same queues.
    void let_go() const;
    // True if the frame in `slot` has finished, or if the device is lost. This function does not wait.
    [[nodiscard]] bool is_over(uint32_t slot) const;

    // Returns the ticket of the frame in `slot`: a timeline semaphore, and the value that it reaches when the
    // frame has finished. The semaphore is null if Weft has submitted the frame itself.
    [[nodiscard]] const FrameTicket& ticket(uint32_t slot) const { return slots_[slot].ticket; }

    // Resets the command buffers of the slot for frame number `frame`. Commands are recorded between begin()
    // and submit(). If `own` is not null, the frame is recorded into this command buffer of the program.
    [[nodiscard]] Status begin(uint32_t slot, uint64_t frame, VkCommandBuffer own);
    [[nodiscard]] BatchCommands batch(uint32_t slot, uint32_t batch) const;
    // Returns the command buffer that is used in frame 0 only. It runs before all batches, on queue 0, and
    // initialises persistent resources.
    [[nodiscard]] VkCommandBuffer prologue(uint32_t slot) const {
        return slots_[slot].own != VK_NULL_HANDLE ? slots_[slot].own : slots_[slot].prologue;
    }
    // Submits the batches of a frame in the order of the plan. `empty` tells which batches have no commands
    // and are left out (index: batch; 1: left out). If the list is empty, all batches are submitted. If the
    // call fails, some of the batches may be in flight. A frame in a command buffer of the program is not
    // submitted here. Such a frame is in flight until the timeline semaphore of its ticket reaches the value
    // of the ticket.
    [[nodiscard]] VkResult submit(uint32_t slot, uint64_t frame, const std::vector<uint8_t>& empty,
                                  const ProgramWaits& own);

 private:
    struct Slot {
        // One command pool for each logical queue.
        std::vector<CommandPoolHandle> pools;
        // One command buffer for each batch of the plan.
        std::vector<VkCommandBuffer> commands;
        VkCommandBuffer prologue = VK_NULL_HANDLE;
        // The program's command buffer for the current frame; null: the frame uses `commands`.
        VkCommandBuffer own = VK_NULL_HANDLE;
        FrameTicket ticket;
        // Signalled at the end of the frame, if the plan has only one batch per frame.
        FenceHandle fence;
        // The frame has finished when all these points are reached. If a frame has several batches, there is
        // one point for each queue: the end of the last batch of the frame on this queue. If the frame is in
        // a command buffer of the program, the point is the ticket of the frame. If the list is empty, the
        // frame has finished when `fence` is signalled.
        std::vector<TimelinePoint> last;
        bool in_flight = false;
    };
    [[nodiscard]] VkResult open(Slot& slot) const;
    [[nodiscard]] VkResult allocate(VkCommandPool pool, VkCommandBuffer& commands) const;
    [[nodiscard]] VkResult submit_alone(Slot& slot, uint64_t frame, const FrameSubmit& how) const;
    [[nodiscard]] VkResult open_gate(const FrameSubmit& how, const std::vector<uint32_t>& batches,
                                     TimelinePoint& gate);
    [[nodiscard]] VkResult close_frame(const Slot& slot, const FrameSubmit& how) const;
    [[nodiscard]] VkResult submit_batch(const Slot& slot, uint32_t batch, uint64_t frame,
                                        const std::vector<TimelinePoint>& gates, const ProgramWaits& own);
    [[nodiscard]] VkResult submit_batches(Slot& slot, uint64_t frame, const std::vector<uint8_t>& empty,
                                          const ProgramWaits& own);

    Device* device_ = nullptr;
    std::vector<PlanQueue> queues_;
    // Index of the queue of each batch.
    std::vector<QueueIndex> queue_of_;
    QueueTimelines timelines_;
    std::array<Slot, kFramesInFlight> slots_;
    // True after the first call of submit().
    bool submitted_ = false;
};

}  // namespace weft::vk
