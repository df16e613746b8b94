// Purpose: records the plan's barriers. Every list of barriers becomes one vkCmdPipelineBarrier2. If the
// device has fewer queue families than the plan, two families of the plan can be one family of the device; an
// ownership transfer between them becomes an ordinary barrier.
#pragma once

#include <span>

#include "graph/rest/frame_steps.h"
#include "vulkan/memory/resource_table.h"

namespace weft::vk {

// Records the barriers of a list with one command, or records nothing if no barrier of the list has to be
// recorded. `step` decides which of the barriers are recorded. `is_before` is true if the list belongs before
// a pass, and false if it belongs after a pass.
void record_barriers(const Device& device, VkCommandBuffer commands, std::span<const BarrierDecl> barriers,
                     const FramePlan& plan, const FrameResources& resources, const FrameStep& step = {},
                     bool is_before = true);

}  // namespace weft::vk
