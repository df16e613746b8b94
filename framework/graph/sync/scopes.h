// Purpose: finds the passes that draw into the rendering scope of the previous pass. Inside one scope the
// rasteriser keeps the order of draws to the attachments (Vulkan 1.3 specification, "Rasterization Order").
// So no barrier is needed, and a tile-based GPU keeps the attachments in on-chip memory. find_scopes() finds
// candidates from the declarations. A candidate is removed later if a barrier must be recorded between the
// two passes, or if the second pass begins a new batch (queue submission).
#pragma once

#include <vector>

#include "graph/schedule/attachment_ops.h"
#include "graph/sync/track_resource.h"
#include "weft/plan.h"

namespace weft {

// Index: position. If the pass continues the rendering scope of another pass: the position of that pass,
// which is the previous pass on the same queue. Otherwise kNoId.
using ScopeTable = std::vector<Position>;

[[nodiscard]] ScopeTable find_scopes(const ResolvedGraph& graph, const Schedule& order,
                                     const AttachmentTable& attachments);
// Returns `scopes` without the passes before which one of the barriers must be recorded: such a pass cannot
// continue the rendering scope of the previous pass.
[[nodiscard]] ScopeTable undivided(ScopeTable scopes, std::span<const PlacedBarrier> barriers);
// Returns `scopes` without the passes that begin a batch (a queue submission), because a rendering scope
// cannot continue in another batch.
[[nodiscard]] ScopeTable within_batches(ScopeTable scopes, const SubmissionPlan& submissions);

// Returns the pass whose rendering scope the pass at `position` continues. Returns kNoId if the pass begins
// its own scope or does not draw.
[[nodiscard]] PassId continued_pass(const FramePlan& plan, Position position);

}  // namespace weft
