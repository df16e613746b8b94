// Purpose: initialises the persistent resources of a plan that follows another plan: records the copies,
// scaling blits and clears of a TransitionPlan, in place of the prologue.
#pragma once

#include "vulkan/memory/resource_table.h"
#include "weft/transition.h"

namespace weft::vk {

// The resources of one plan, in the frame after its last one.
struct PlanSide {
    const FramePlan& plan;
    FrameResources resources;
};

void record_transition(const Device& device, VkCommandBuffer commands, const TransitionPlan& transition,
                       const PlanSide& from, const PlanSide& to);

}  // namespace weft::vk
