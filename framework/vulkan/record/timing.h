// Purpose: measures GPU times of passes with timestamp queries: one at the start of each batch and one after
// each pass. The time of a pass includes waiting for its own barriers, but not the wait of its batch; the
// store operations of a rendering scope count in the time of its last pass. Times in ms. Errors: V418.
#pragma once

#include <array>
#include <vector>

#include "vulkan/device/handle.h"
#include "weft/vulkan/executor.h"

namespace weft::vk {

class PassTimer {
 public:
    // Does nothing unless `enabled`. Passes on queues without timestamps have negative times.
    [[nodiscard]] static Result<PassTimer> create(Device& device, const FramePlan& plan, bool enabled);

    // Resets the slot's queries, after its last frame has finished.
    void reset(uint32_t slot) const;
    void record_batch_start(VkCommandBuffer commands, uint32_t slot, uint32_t batch) const;
    void record_pass_end(VkCommandBuffer commands, uint32_t slot, uint32_t position) const;
    // Indexed by schedule position; call this after the slot's frame has finished.
    [[nodiscard]] std::vector<double> read_ms(uint32_t slot) const;
    // The first position whose end has not been reached; the number of passes if unknown. For a slot that
    // hangs.
    [[nodiscard]] uint32_t first_unfinished(uint32_t slot) const;

 private:
    struct Stamp {
        uint64_t ticks = 0;
        uint64_t available = 0;
    };
    void write(VkCommandBuffer commands, uint32_t slot, uint32_t query, bool inside_scope) const;
    [[nodiscard]] std::vector<Stamp> stamps(uint32_t slot) const;  // index: query; empty when disabled
    [[nodiscard]] uint32_t end_query(size_t position) const;

    Device* device_ = nullptr;
    std::vector<uint8_t> batch_timed_;   // index: batch
    std::vector<uint8_t> inside_scope_;  // index: schedule position; 1 if the next pass continues the same
                                         // rendering scope
    std::vector<uint32_t> before_;  // index: schedule position; the previous query on its queue; kNoId if not
                                    // timed
    std::array<QueryPoolHandle, kFramesInFlight> pools_;
};

}  // namespace weft::vk
