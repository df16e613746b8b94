// Purpose: the plan's barriers as Vulkan's: every list is one vkCmdPipelineBarrier2. Where the device has
// fewer families than the plan, a transfer between two that are one is a barrier like any other.
#pragma once

#include <span>

#include "vulkan/memory/resource_table.h"

namespace weft::vk {

// Records nothing for an empty list.
void record_barriers(const Device& device, VkCommandBuffer commands, std::span<const BarrierDecl> barriers,
                     const FramePlan& plan, const FrameResources& resources);

}  // namespace weft::vk
