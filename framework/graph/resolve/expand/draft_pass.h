// Purpose: finds the parts of a pass that follow from its own description: kind, shader and fixed-function
// state. Private to expand().
#pragma once

#include "graph/resolve/pass_reporter.h"

namespace weft {

// Returns the fixed-function state of a pass. Its numbers are expressions that may depend on the indices of a
// repeat.
[[nodiscard]] RasterState evaluate_state(const PassDesc& desc, const Evaluator& evaluator);
// Checks that the device supports the fixed-function state of the pass. Errors: W187.
void check_state(const DeviceProfile& profile, PassId id, const PassDraft& draft, PassReporter& report);
// Finds the kind of a pass from its type: a built-in type or a C++ pass type. Errors: W115.
void find_kind(const ResolveInput& input, PassId id, PassDraft& draft, PassReporter& report);
// Finds the shader of a pass and checks that it has the needed stage. If the shader failed to compile, marks
// the pass as suspect, so that later stages report no consequences. Errors: W177.
void find_shader(const ResolveInput& input, PassId id, PassDraft& draft, Suspects& suspects,
                 PassReporter& report);

}  // namespace weft
