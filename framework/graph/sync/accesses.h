// Purpose: lists all accesses to each resource in schedule order, including the load and store operations of
// attachments. Dependencies between queues and barriers are computed from these lists.
#pragma once

#include <vector>

#include "graph/model/rows.h"
#include "graph/schedule/attachment_ops.h"
#include "weft/plan.h"

namespace weft {

// An access of one pass to a subresource or a range. If several ports of the pass use the same subresource,
// append_access() merges their accesses into one event.
struct AccessEvent {
    // The program's read between frames (ResourceDecl::between) has the position after the last pass.
    Position position = 0;
    PassId pass = kNoId;  // kNoId: the program.
    QueueIndex queue = kGraphicsQueue;
    AccessState state;
    bool writes = false;
    bool reads = false;
    // For the access of an attachment: position of the previous pass on the same queue, if this pass
    // continues the rendering scope of that pass. Otherwise kNoId.
    Position merged_position = kNoId;
};

struct RangeAccess {
    SubresourceRange range;
    AccessEvent event;
};

// Adds an access to the accesses of one subresource, sorted by schedule position. If several ports of one
// pass use the subresource, their accesses become one event; resolve() has already checked that they need the
// same layout.
void append_access(const AccessEvent& event, std::vector<AccessEvent>& accesses);

// Index: ResourceId. The accesses to the resource, sorted by schedule position. For collect_accesses(),
// `scopes[p]` is the position of the pass whose rendering scope the pass at position p continues, or kNoId.
using AccessTable = Rows<RangeAccess>;
[[nodiscard]] AccessTable collect_accesses(const ResolvedGraph& graph, const Schedule& order,
                                           const AttachmentTable& attachments,
                                           const std::vector<Position>& scopes);

}  // namespace weft
