// Purpose: load and store operations of all attachments. Later stages count them as accesses.
#pragma once

#include <vector>

#include "weft/declaration.h"
#include "weft/plan.h"

namespace weft {

// By position in the order, then by attachment: colours by location, then depth.
using AttachmentTable = std::vector<std::vector<AttachmentOps>>;

[[nodiscard]] AttachmentTable attachment_ops(const ResolvedGraph& graph, const LiveGraph& live,
                                             const Schedule& order);

}  // namespace weft
