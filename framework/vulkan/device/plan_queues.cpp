#include "vulkan/device/plan_queues.h"

namespace weft::vk {

uint32_t device_family(const Device& device, uint32_t family) {
    const bool there = family < device.families().size() && !device.families()[family].queues.empty();
    return there ? family : device.queue().family;
}

std::vector<PlanQueue> map_queues(const Device& device, const std::vector<LogicalQueue>& logical) {
    std::vector<PlanQueue> queues;
    std::vector<size_t> taken(device.families().size(), 0);
    for (size_t i = 0; i < logical.size(); ++i) {
        const uint32_t family = i == 0 ? device.queue().family : device_family(device, logical[i].family);
        const QueueFamily& offered = device.families()[family];
        const VkQueue handle = offered.queues[taken[family]++ % offered.queues.size()];
        queues.push_back({handle, family,
                          (offered.flags & (VK_QUEUE_GRAPHICS_BIT | VK_QUEUE_COMPUTE_BIT)) != 0,
                          offered.timestamps});
    }
    return queues;
}

}  // namespace weft::vk
