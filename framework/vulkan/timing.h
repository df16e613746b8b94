// Purpose: GPU times of the passes of a frame by timestamp queries: one at the start and one after each pass.
// A pass's time includes the wait of its own barriers.
// Times in ms. Errors: V418.
#pragma once

#include <array>
#include <vector>

#include "vulkan/executor.h"
#include "vulkan/handle.h"

namespace weft::vk {

class PassTimer {
 public:
    // Off when not `enabled` or when the queue has no timestamps: then nothing is recorded and times are
    // negative.
    [[nodiscard]] static Result<PassTimer> create(Device& device, uint32_t pass_count, bool enabled);

    void record_start(VkCommandBuffer commands, uint32_t slot) const;
    void record_pass_end(VkCommandBuffer commands, uint32_t slot, uint32_t position) const;
    // By position, after the slot's fence.
    [[nodiscard]] std::vector<double> read_ms(uint32_t slot) const;
    // The first position whose end has not been reached; the pass count when unknown. For a slot that hangs.
    [[nodiscard]] uint32_t first_unfinished(uint32_t slot) const;

 private:
    void write(VkCommandBuffer commands, uint32_t slot, uint32_t query) const;

    Device* device_ = nullptr;
    uint32_t pass_count_ = 0;
    std::array<QueryPoolHandle, kFramesInFlight> pools_;
};

}  // namespace weft::vk
