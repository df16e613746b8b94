// Purpose: explains a plan in sentences that name the places in the graph's files. Each answer is a few lines
// that end with a newline, made from the plan alone. Positions are in execution order, from 0. The name of a
// repeat selects all its rounds. Errors: W104 no such pass, W103 no such resource.
#pragma once

#include <string>

#include "weft/plan.h"
#include "weft/result.h"

namespace weft {

// The reason why the pass is culled, or the passes that need it.
[[nodiscard]] Result<std::string> explain_culled(const FramePlan& plan, const std::string& pass);
// Every barrier before `second` that waits for `first`, or the reason why there is none.
[[nodiscard]] Result<std::string> explain_barrier(const FramePlan& plan, const std::string& first,
                                                  const std::string& second);
// Tells whether two resources share memory, and why not.
[[nodiscard]] Result<std::string> explain_alias(const FramePlan& plan, const std::string& a,
                                                const std::string& b);
// The waits of the pass for other queues, and the passes that wait for it.
[[nodiscard]] Result<std::string> explain_wait(const FramePlan& plan, const std::string& pass);
// The properties of the resource, its writers and readers, its lifetime and its place in memory.
[[nodiscard]] Result<std::string> explain_resource(const FramePlan& plan, const std::string& resource);

}  // namespace weft
