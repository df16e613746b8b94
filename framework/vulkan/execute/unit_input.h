// Purpose: collects, as bytes, the inputs of a resting pass that do not come from other passes, for one
// frame: the Params of the pass, the constants of frame and view that its shader reads, and the versions of
// its draw lists and of its imports. If the bytes equal those of the last run, these inputs have not changed.
#pragma once

#include <span>
#include <string>

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
// Returns a text about the first input that differs from the last run of the unit, for example `member
// "power" of Params of pass "base"`. `positions` are the passes of the unit, `last` are the bytes of its last
// run.
[[nodiscard]] std::string changed_input(const UnitInputContext& context, std::span<const Position> positions,
                                        std::span<const std::byte> last);

}  // namespace weft::vk
