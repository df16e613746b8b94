// Purpose: some reads do not happen in every frame. This file adds them to the source scopes of the barriers
// that wait for them. A barrier after a read needs no access in its source scope. But if the pass that reads
// is switched off, this barrier must wait for the write before the read. It does so through a chain with the
// barrier between that write and the read. The validation layer of
// Vulkan 1.3.239 follows such a chain only if the later barrier names an access to which the earlier barrier
// has made the write visible.
#pragma once

#include "weft/plan.h"

namespace weft {

// Adds the reads of passes with switches, and of inputs that depend on switches, to the source scopes of the
// barriers on the resources that they read.
void name_skipped_reads(const ResolvedGraph& graph, BarrierPlan& plan);

}  // namespace weft
