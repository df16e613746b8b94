// Purpose: records the commands that initialise the persistent resources of a plan that replaces another
// plan: the copies, scaling blits and clears of a TransitionPlan. They replace the new plan's prologue.
#pragma once

#include "vulkan/memory/frame_areas.h"
#include "vulkan/memory/resource_table.h"
#include "weft/transition.h"

namespace weft::vk {

// One of the two plans of a transition, and the Vulkan objects of its resources in one frame. For the new
// plan, this is frame 0. For the old plan, it is the frame after the last frame of this plan. That frame
// never runs, but it is used here because it would read the contents that are copied.
struct PlanSide {
    const FramePlan& plan;
    FrameResources resources;
    const FrameAreas& areas;
};

void record_transition(const Device& device, VkCommandBuffer commands, const TransitionPlan& transition,
                       const PlanSide& from, const PlanSide& to);

}  // namespace weft::vk
