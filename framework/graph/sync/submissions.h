// Purpose: computes the batches that each queue submits, and the semaphore waits and signals between the
// batches.
#pragma once

#include <vector>

#include "weft/plan.h"

namespace weft {

[[nodiscard]] SubmissionPlan submissions(const Schedule& order,
                                         const std::vector<QueueDependency>& dependencies);

}  // namespace weft
