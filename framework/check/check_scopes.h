// Purpose: checks every pass that continues the rendering scope of the previous pass: it must use the same
// attachments, load them without clearing, and need no commands between the two passes. Errors: C306.
#pragma once

#include "check/fault_list.h"
#include "weft/plan.h"

namespace weft::check {

void check_scopes(const FramePlan& plan, FaultList& faults);

[[nodiscard]] bool is_attachment(const PassDecl& pass, uint32_t use);

}  // namespace weft::check
