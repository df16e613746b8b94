// Purpose: which passes draw into the rendering scope of the pass before them. Inside a scope the rasteriser
// keeps the order of passes in what they draw to (Vulkan 1.3 specification, "Rasterization Order"), so that
// nothing has to be waited for, and a tiler keeps the attachments on chip. Candidates follow from the
// declarations; those that something has to be recorded in front of fall out once barriers and batches are
// known.
#pragma once

#include <vector>

#include "graph/schedule/attachment_ops.h"
#include "graph/sync/track_resource.h"
#include "weft/plan.h"

namespace weft {

// By position: that of the pass whose scope it continues, the one before it on its queue; else kNoId.
using ScopeTable = std::vector<uint32_t>;

[[nodiscard]] ScopeTable find_scopes(const ResolvedGraph& graph, const Schedule& order,
                                     const AttachmentTable& attachments);
// Without those that barriers stand in front of.
[[nodiscard]] ScopeTable undivided(ScopeTable scopes, const std::vector<ResourceHistory>& histories);
// Without those that are submitted in another batch.
[[nodiscard]] ScopeTable within_batches(ScopeTable scopes, const SubmissionPlan& submissions);

// The pass whose rendering scope the one at `position` goes on in; kNoId: it begins its own, or draws
// nothing.
[[nodiscard]] PassId continued_pass(const FramePlan& plan, uint32_t position);

}  // namespace weft
