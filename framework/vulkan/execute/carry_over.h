// Purpose: what a plan's first frame finds in persistent resources when another plan ran before: the copies,
// stretches and clears of a TransitionPlan, instead of the prologue.
#pragma once

#include "vulkan/memory/resource_table.h"
#include "weft/transition.h"

namespace weft::vk {

// One plan's resources, in the frame that would come next.
struct PlanSide {
    const FramePlan& plan;
    FrameResources resources;
};

void record_transition(const Device& device, VkCommandBuffer commands, const TransitionPlan& transition,
                       const PlanSide& from, const PlanSide& to);

}  // namespace weft::vk
