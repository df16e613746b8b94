// Purpose: records the plan's barriers. Every list of barriers becomes one vkCmdPipelineBarrier2. If the
// device has fewer queue families than the plan, two families of the plan can be one family of the device; an
// ownership transfer between them becomes an ordinary barrier.
#pragma once

#include <span>

#include "vulkan/memory/resource_table.h"

namespace weft::vk {

// Records the barriers of a list with one command; records nothing if there is none to record. `pass_rests`
// is true if the pass of the step does not run in this frame: then barriers with if_pass_runs are left out.
void record_barriers(const Device& device, VkCommandBuffer commands, std::span<const BarrierDecl> barriers,
                     const FramePlan& plan, const FrameResources& resources, bool pass_rests = false);

}  // namespace weft::vk
