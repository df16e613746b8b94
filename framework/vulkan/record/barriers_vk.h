// Purpose: records the plan's barriers; every list becomes one vkCmdPipelineBarrier2. If the device has fewer
// families than the plan, a transfer between two plan families that are one family of the device becomes an
// ordinary barrier.
#pragma once

#include <span>

#include "vulkan/memory/resource_table.h"

namespace weft::vk {

// Records nothing for an empty list.
void record_barriers(const Device& device, VkCommandBuffer commands, std::span<const BarrierDecl> barriers,
                     const FramePlan& plan, const FrameResources& resources);

}  // namespace weft::vk
