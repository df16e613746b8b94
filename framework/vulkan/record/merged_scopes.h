// Purpose: finds the passes of a plan that share one rendering scope (vkCmdBeginRendering to
// vkCmdEndRendering).
#pragma once

#include "weft/plan.h"

namespace weft::vk {

// True if the next pass on the same queue continues the rendering scope of the pass at `position`.
[[nodiscard]] bool scope_continues(const FramePlan& plan, Position position);

// Returns the plan's step at `position`, but with the store operations of the last pass in the same rendering
// scope, because attachments are stored when the scope ends.
[[nodiscard]] PassStep step_of_scope(const FramePlan& plan, Position position);

}  // namespace weft::vk
