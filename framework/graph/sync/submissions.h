// Purpose: the batches that each queue submits, with their waits and signals.
#pragma once

#include <vector>

#include "weft/plan.h"

namespace weft {

[[nodiscard]] SubmissionPlan submissions(const Schedule& order,
                                         const std::vector<QueueDependency>& dependencies);

}  // namespace weft
