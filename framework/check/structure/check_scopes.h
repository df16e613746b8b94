// Purpose: checks every pass that continues the rendering scope (vkCmdBeginRendering) of the previous pass.
// Such a pass must use the same attachments and load them without clearing. No barriers may be recorded
// between the two passes. Errors: C306.
#pragma once

#include "check/faults/fault_list.h"
#include "weft/plan.h"

namespace weft::check {

void check_scopes(const FramePlan& plan, FaultList& faults);

[[nodiscard]] bool is_attachment(const PassDecl& pass, uint32_t use);

}  // namespace weft::check
