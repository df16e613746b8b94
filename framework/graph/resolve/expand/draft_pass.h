// Purpose: determines the parts of a pass that follow from its own description: kind, shader, fixed-function
// state. Private to expand().
#pragma once

#include "graph/resolve/pass_reporter.h"

namespace weft {

// The fixed-function state. Its numbers may depend on the indices of a repeat.
[[nodiscard]] RasterState evaluate_state(const PassDesc& desc, const Evaluator& evaluator);
// Checks that the device supports the state. Errors: W187.
void check_state(const DeviceProfile& profile, PassId id, const PassDraft& draft, PassReporter& report);
// Errors: W115.
void find_kind(const ResolveInput& input, PassId id, PassDraft& draft, PassReporter& report);
// Errors: W177. A pass whose shader failed to compile is suspect.
void find_shader(const ResolveInput& input, PassId id, PassDraft& draft, Suspects& suspects,
                 PassReporter& report);

}  // namespace weft
