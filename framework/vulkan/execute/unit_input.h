// Purpose: collects everything outside other passes that the result of a resting pass depends on in a frame,
// as bytes: its Params, the constants of frame and view that its shader reads, the versions of its draw lists
// and of its imports. If the bytes are those of the last run, these inputs have not changed.
#pragma once

#include "graph/rest/rest_state.h"
#include "vulkan/record/plan_objects.h"

namespace weft::vk {

struct UnitInputContext {
    const PlanObjects& objects;
    const FrameInput& frame;
    FrameResources resources;
    uint32_t slot = 0;
};

// Appends the inputs of the pass at `position` to the inputs of its unit. The result is nullopt if an input
// may change in every frame.
void add_unit_input(const UnitInputContext& context, Position position, UnitInput& input);

}  // namespace weft::vk
