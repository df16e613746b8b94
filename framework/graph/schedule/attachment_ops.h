// Purpose: chooses the load and store operations of all attachments. collect_accesses() later adds
// the memory accesses of these operations to those of the pass.
#pragma once

#include <vector>

#include "weft/declaration.h"
#include "weft/plan.h"

namespace weft {

// Indexed by the pass's position in the schedule, then by attachment: colour attachments sorted by location,
// then the depth attachment.
using AttachmentTable = std::vector<std::vector<AttachmentOps>>;

[[nodiscard]] AttachmentTable attachment_ops(const ResolvedGraph& graph, const LiveGraph& live,
                                             const Schedule& order);

}  // namespace weft
