// Purpose: records the commands that initialise the persistent resources of a plan that replaces another
// plan: the copies, scaling blits and clears of a TransitionPlan. They replace the new plan's prologue.
#pragma once

#include "vulkan/memory/resource_table.h"
#include "weft/transition.h"

namespace weft::vk {

// One of the two plans of a transition (the old or the new one), and the Vulkan objects of its resources in
// its next frame. The old plan does not run that frame any more; for the new plan it is frame 0.
struct PlanSide {
    const FramePlan& plan;
    FrameResources resources;
};

void record_transition(const Device& device, VkCommandBuffer commands, const TransitionPlan& transition,
                       const PlanSide& from, const PlanSide& to);

}  // namespace weft::vk
