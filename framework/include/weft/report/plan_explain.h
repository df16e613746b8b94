// Purpose: why a plan is as it is, in sentences that name the places in the graph's files. Each answer is a
// few lines that end in a newline, made from the plan alone. Positions count in the order of execution, from
// 0. The name of a repeat stands for all its
// rounds where one name is asked for. Errors: W104 no such pass, W103 no such resource.
#pragma once

#include <string>

#include "weft/plan.h"
#include "weft/result.h"

namespace weft {

// Why the pass does not run, or who needs it.
[[nodiscard]] Result<std::string> explain_culled(const FramePlan& plan, const std::string& pass);
// Every barrier before `second` that waits for `first`, or why there is none.
[[nodiscard]] Result<std::string> explain_barrier(const FramePlan& plan, const std::string& first,
                                                  const std::string& second);
// Whether two resources share memory, and why not.
[[nodiscard]] Result<std::string> explain_alias(const FramePlan& plan, const std::string& a,
                                                const std::string& b);
// What the pass waits for on other queues, and who waits for it.
[[nodiscard]] Result<std::string> explain_wait(const FramePlan& plan, const std::string& pass);
// What it is, who writes and reads it, when it lives and where.
[[nodiscard]] Result<std::string> explain_resource(const FramePlan& plan, const std::string& resource);

}  // namespace weft
