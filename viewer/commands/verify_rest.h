// Purpose: the option --verify-rest of `weft render`. It renders the frames twice, in two sessions: in one
// session, passes with "rest" do not run while their inputs stay the same; in the other session, they run in
// every frame. In each frame, all resources that these passes write must have the same bytes in both
// sessions. Errors: W189, and those of open_session().
#pragma once

#include <cstdint>

#include "viewer/commands/commands.h"
#include "weft/plan.h"
#include "weft/result.h"

namespace weft::viewer {

// `plan` is the plan of the graph that `options` select.
[[nodiscard]] Status verify_rest(const RenderOptions& options, const FramePlan& plan, uint32_t frames);

}  // namespace weft::viewer
