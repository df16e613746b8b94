// Purpose: the accesses of the passes of a schedule to every resource, in order. Dependencies and barriers
// follow from them. Load and store operations count as accesses.
#pragma once

#include <vector>

#include "graph/schedule/attachment_ops.h"
#include "weft/plan.h"

namespace weft {

// All that one pass does to one subresource; several ports of a pass are one event.
struct AccessEvent {
    uint32_t position = 0;
    PassId pass = kNoId;
    QueueIndex queue = 0;
    AccessState state;
    bool writes = false;
    bool reads = false;
    uint32_t merged_position = kNoId;  // the earlier pass whose rendering scope this one continues
};

struct RangeAccess {
    SubresourceRange range;
    AccessEvent event;
};

// By resource, in order of position. `scopes` says by position the pass whose rendering scope a pass
// continues.
using AccessTable = std::vector<std::vector<RangeAccess>>;
[[nodiscard]] AccessTable collect_accesses(const ResolvedGraph& graph, const Schedule& order,
                                           const AttachmentTable& attachments,
                                           const std::vector<uint32_t>& scopes);

}  // namespace weft
