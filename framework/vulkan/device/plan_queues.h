// Purpose: maps the logical queues of a plan to the device's queues. Logical queues share a queue if the
// device has fewer. A family in which the device has no queue is replaced by the family of its main queue.
#pragma once

#include <vector>

#include "weft/plan.h"
#include "weft/vulkan/device.h"

namespace weft::vk {

struct PlanQueue {
    VkQueue handle = VK_NULL_HANDLE;
    uint32_t family = 0;
    bool labels = false;  // the queue supports debug labels, because it draws or computes
    bool timestamps = false;
};

// Indexed by QueueIndex. The first one is always Device::queue().
[[nodiscard]] std::vector<PlanQueue> map_queues(const Device& device,
                                                const std::vector<LogicalQueue>& logical);

// The device's family that is used for `family` of the plan.
[[nodiscard]] uint32_t device_family(const Device& device, uint32_t family);

}  // namespace weft::vk
