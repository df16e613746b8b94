// Purpose: answers questions about a plan in sentences that name the places in the graph's files. Each answer
// is a few lines that end with a newline, and uses only the plan. Positions are in execution order, from 0.
// The name of a pass with `repeat` selects all passes that the repeat makes. Errors: W104 no such pass, W103
// no such resource.
#pragma once

#include <string>

#include "weft/plan.h"
#include "weft/result.h"

namespace weft {

// Explains why the pass is culled, or names the passes that need it.
[[nodiscard]] Result<std::string> explain_culled(const FramePlan& plan, const std::string& pass);
// Explains every barrier before pass `second` that waits for pass `first`, or why there is no such barrier.
[[nodiscard]] Result<std::string> explain_barrier(const FramePlan& plan, const std::string& first,
                                                  const std::string& second);
// Tells whether two resources share memory, and if not, why.
[[nodiscard]] Result<std::string> explain_alias(const FramePlan& plan, const std::string& a,
                                                const std::string& b);
// Explains for which passes on other queues the pass waits, and which passes wait for it.
[[nodiscard]] Result<std::string> explain_wait(const FramePlan& plan, const std::string& pass);
// Tells whether the pass rests (is skipped while its inputs do not change), with which passes it runs
// together, and which changes make it run.
[[nodiscard]] Result<std::string> explain_rest(const FramePlan& plan, const std::string& pass);
// Tells when the pass is switched off and what its readers see then, and which of its inputs depend on
// switches.
[[nodiscard]] Result<std::string> explain_switch(const FramePlan& plan, const std::string& pass);
// Tells which views the pass draws, whether it draws them together, and why.
[[nodiscard]] Result<std::string> explain_views(const FramePlan& plan, const std::string& pass);
// Lists the properties of the resource, its writers and readers, its lifetime and its place in memory.
[[nodiscard]] Result<std::string> explain_resource(const FramePlan& plan, const std::string& resource);

}  // namespace weft
