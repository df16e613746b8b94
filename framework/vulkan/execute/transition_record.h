// Purpose: records the commands that initialise the persistent resources of a plan that replaces another
// plan: the copies, scaling blits and clears of a TransitionPlan. They run in place of the plan's prologue.
#pragma once

#include "vulkan/memory/resource_table.h"
#include "weft/transition.h"

namespace weft::vk {

// One of the two plans of a transition, and the Vulkan objects that its resources have in the frame that
// would run next.
struct PlanSide {
    const FramePlan& plan;
    FrameResources resources;
};

void record_transition(const Device& device, VkCommandBuffer commands, const TransitionPlan& transition,
                       const PlanSide& from, const PlanSide& to);

}  // namespace weft::vk
