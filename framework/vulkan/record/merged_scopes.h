// Purpose: rendering scopes that several passes of a plan share.
#pragma once

#include "weft/plan.h"

namespace weft::vk {

// True if the next pass on the same queue continues the rendering scope of the pass at `position`.
[[nodiscard]] bool scope_goes_on(const FramePlan& plan, uint32_t position);

// The step at `position`, with the store operations of the last pass in its scope.
[[nodiscard]] PassStep step_of_scope(const FramePlan& plan, uint32_t position);

}  // namespace weft::vk
