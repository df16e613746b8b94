// Purpose: GPU times of the passes of a frame by timestamp queries: one at the start of each batch and one
// after each pass. A pass's time includes the wait of its own barriers, but not that of its batch; what a
// rendering scope stores is in the time of its last pass.
// Times in ms. Errors: V418.
#pragma once

#include <array>
#include <vector>

#include "weft/vulkan/executor.h"
#include "weft/vulkan/handle.h"

namespace weft::vk {

class PassTimer {
 public:
    // Off when not `enabled`. Passes on queues without timestamps have negative times.
    [[nodiscard]] static Result<PassTimer> create(Device& device, const FramePlan& plan, bool enabled);

    // Forgets the slot's last frame, which is over.
    void reset(uint32_t slot) const;
    void record_batch_start(VkCommandBuffer commands, uint32_t slot, uint32_t batch) const;
    void record_pass_end(VkCommandBuffer commands, uint32_t slot, uint32_t position) const;
    // By position, once the slot's frame is over.
    [[nodiscard]] std::vector<double> read_ms(uint32_t slot) const;
    // The first position whose end has not been reached; the pass count when unknown. For a slot that hangs.
    [[nodiscard]] uint32_t first_unfinished(uint32_t slot) const;

 private:
    struct Stamp {
        uint64_t ticks = 0;
        uint64_t available = 0;
    };
    void write(VkCommandBuffer commands, uint32_t slot, uint32_t query, bool inside_scope) const;
    [[nodiscard]] std::vector<Stamp> stamps(uint32_t slot) const;  // by query; empty when off
    [[nodiscard]] uint32_t end_query(size_t position) const;

    Device* device_ = nullptr;
    std::vector<uint8_t> batch_timed_;   // by batch
    std::vector<uint8_t> inside_scope_;  // by position: the next pass goes on in the same rendering scope
    std::vector<uint32_t> before_;  // by position: the query before it on its queue; kNoId when not timed
    std::array<QueryPoolHandle, kFramesInFlight> pools_;
};

}  // namespace weft::vk
