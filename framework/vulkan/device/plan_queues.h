// Purpose: maps the logical queues of a plan to the device's queues. Several logical queues share a queue if
// the device has fewer queues. If the device has created no queue in a queue family of the plan, the family
// of the device's main queue is used instead.
#pragma once

#include <vector>

#include "weft/plan.h"
#include "weft/vulkan/device.h"

namespace weft::vk {

struct PlanQueue {
    VkQueue handle = VK_NULL_HANDLE;
    uint32_t family = 0;
    // True if command buffers of this queue may contain debug labels, which Vulkan allows only on queues that
    // draw or compute.
    bool labels = false;
    bool timestamps = false;
};

// Returns one queue for each logical queue of a plan, indexed by QueueIndex. Element 0 is always
// Device::queue().
[[nodiscard]] std::vector<PlanQueue> map_queues(const Device& device,
                                                const std::vector<LogicalQueue>& logical);

// Returns the queue family of the device that is used for family `family` of a plan: the same family if the
// device has a queue in it, else the family of the main queue.
[[nodiscard]] uint32_t device_family(const Device& device, uint32_t family);

}  // namespace weft::vk
