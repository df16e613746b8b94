// Purpose: whether every pass that draws into the rendering scope of the pass before it may do so: the same
// attachments, seen and never cleared, and nothing that has to be recorded between the two. Errors: C306.
#pragma once

#include "check/fault_list.h"
#include "weft/plan.h"

namespace weft::check {

void check_scopes(const FramePlan& plan, FaultList& faults);

[[nodiscard]] bool is_attachment(const PassDecl& pass, uint32_t use);

}  // namespace weft::check
