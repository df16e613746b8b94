// Purpose: chooses the units that run, with a method of its own, for comparison with RestState. All rounds of
// groups that are awake run.
#pragma once

#include "null/null_executor.h"

namespace weft::test {

// Follows the passes: each part of a resource has a number that changes whenever a pass writes other content.
// A unit runs if the inputs of a pass, or the number of a part that a pass reads, differ from its last run.
[[nodiscard]] RestChoice rest_closure(const FramePlan& plan, const InputChoice& inputs);

}  // namespace weft::test
