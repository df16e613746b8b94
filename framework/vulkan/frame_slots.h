// Purpose: the frames in flight: a command buffer and a fence for each, and what happens when a frame never
// ends. Errors: V407 time-out and V408 device lost name the passes in flight; V418.
#pragma once

#include <array>
#include <functional>
#include <string>

#include "vulkan/executor.h"
#include "vulkan/handle.h"

namespace weft::vk {

class FrameSlots {
 public:
    [[nodiscard]] static Result<FrameSlots> create(Device& device);

    [[nodiscard]] bool in_flight(uint32_t slot) const { return slots_[slot].in_flight; }
    // VK_SUCCESS at once when nothing is in flight.
    [[nodiscard]] VkResult wait(uint32_t slot);
    // Without waiting. On a lost device everything is.
    [[nodiscard]] bool is_over(uint32_t slot) const;
    // The slot's command buffer, empty and recording.
    [[nodiscard]] Result<VkCommandBuffer> begin(uint32_t slot);
    [[nodiscard]] VkResult submit(uint32_t slot);

 private:
    struct Slot {
        CommandPoolHandle pool;
        FenceHandle fence;
        VkCommandBuffer commands = VK_NULL_HANDLE;
        bool in_flight = false;
    };
    [[nodiscard]] static VkResult open(Device& device, Slot& slot);

    Device* device_ = nullptr;
    std::array<Slot, kFramesInFlight> slots_;
};

}  // namespace weft::vk
