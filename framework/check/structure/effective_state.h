// Purpose: finds the stages and accesses of a use of a pass. The load and store operations of an attachment
// are accesses, too.
#pragma once

#include "weft/plan.h"

namespace weft::check {

// Returns the stages and accesses of a use, including those of the attachment's load and store operations.
[[nodiscard]] AccessState effective_state(const UseDecl& use, const AttachmentOps* ops);
// Returns the operations of an attachment; null if the step lists none for this use.
[[nodiscard]] const AttachmentOps* ops_of(const PassStep& step, uint32_t use);

}  // namespace weft::check
