// Purpose: the logical queues of a plan on the queues that a device has. Several share one where there are
// fewer; a family that the device has no queue of is that of its main queue.
#pragma once

#include <vector>

#include "weft/plan.h"
#include "weft/vulkan/device.h"

namespace weft::vk {

struct PlanQueue {
    VkQueue handle = VK_NULL_HANDLE;
    uint32_t family = 0;
    bool labels = false;  // debug labels need a queue that draws or computes
    bool timestamps = false;
};

// By QueueIndex. The first one is always Device::queue().
[[nodiscard]] std::vector<PlanQueue> map_queues(const Device& device,
                                                const std::vector<LogicalQueue>& logical);

// The family that stands in for `family` of the plan.
[[nodiscard]] uint32_t device_family(const Device& device, uint32_t family);

}  // namespace weft::vk
