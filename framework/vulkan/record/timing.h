// Purpose: measures the GPU time of each pass with timestamp queries: one query at the start of each batch
// and one after each pass. The time of a pass includes the wait at its own barriers, but not the wait of its
// batch for semaphores. The store operations of a rendering scope count in the time of its last pass. Times
// are in ms. Errors: V418 (the queries could not be created).
#pragma once

#include <array>
#include <vector>

#include "vulkan/device/handle.h"
#include "weft/vulkan/executor.h"

namespace weft::vk {

class PassTimer {
 public:
    // If `enabled` is false, the timer records nothing. A pass gets a negative time if the timer is disabled,
    // or if the queue of the pass has no timestamps.
    [[nodiscard]] static Result<PassTimer> create(Device& device, const FramePlan& plan, bool enabled);

    // Resets the queries of a frame slot. Call this after the slot's last frame has finished.
    void reset(uint32_t slot);
    // The passes of a batch may be recorded in any order. The time of a pass counts from the end of the pass
    // that was recorded before it, or else from the start of the batch.
    void record_batch_start(VkCommandBuffer commands, uint32_t slot, uint32_t batch);
    void record_pass_end(VkCommandBuffer commands, uint32_t slot, Position position);
    // Returns the time of each pass in ms, indexed by the position of the pass in the execution order. The
    // time of a pass whose end was not recorded in the frame is 0. Call this after the slot's frame has
    // finished.
    [[nodiscard]] std::vector<double> read_ms(uint32_t slot) const;
    // Finds the pass in which a frame hangs: the position, in the execution order, of the first pass whose
    // end the GPU has not reached. Returns the number of passes if this is unknown.
    [[nodiscard]] uint32_t first_unfinished(uint32_t slot) const;

 private:
    struct Stamp {
        uint64_t ticks = 0;
        uint64_t available = 0;
    };
    void write(VkCommandBuffer commands, uint32_t slot, uint32_t query, bool inside_scope) const;
    // Reads all queries of a frame slot. Returns an empty list if there are none or if reading fails.
    [[nodiscard]] std::vector<Stamp> stamps(uint32_t slot) const;
    // Returns the index of the query at the end of the pass at index `position` of the execution order. The
    // queries before these are for the starts of the batches: query i for batch i.
    [[nodiscard]] uint32_t end_query(size_t position) const;

    Device* device_ = nullptr;
    // For each batch, 1 if its passes are timed.
    std::vector<uint8_t> batch_timed_;
    // For each pass, in execution order, 1 if the next pass continues the same rendering scope.
    std::vector<uint8_t> inside_scope_;
    // For each pass, in execution order, 1 if the pass is timed.
    std::vector<uint8_t> pass_timed_;
    // For each frame slot, then for each pass: the index of the query from which the time of the pass counts,
    // or kNoId if the end of the pass was not recorded in the frame.
    std::array<std::vector<uint32_t>, kFramesInFlight> before_;
    uint32_t last_query_ = kNoId;  // The query that was recorded last.
    std::array<QueryPoolHandle, kFramesInFlight> pools_;
};

}  // namespace weft::vk
