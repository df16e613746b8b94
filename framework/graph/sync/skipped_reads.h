// Purpose: some reads do not happen in every frame, because a switch turns the reading pass off. This file
// adds such reads to the source scopes of the barriers that wait for them. A barrier after a read normally
// needs no access in its source scope. But if the reading pass is off, this barrier must wait for the write
// before the read. It waits only indirectly: an earlier barrier stands between the write and the read, and
// the later barrier waits for the stages of the earlier barrier. The validation layer of Vulkan 1.3.239
// follows such a chain of barriers only if the later barrier names an access to which the earlier barrier has
// made the write visible.
#pragma once

#include "weft/plan.h"

namespace weft {

// Adds the reads of passes with switches, and of inputs that depend on switches, to the source scopes of the
// barriers on the resources that they read.
void name_skipped_reads(const ResolvedGraph& graph, BarrierPlan& plan);

}  // namespace weft
