// Purpose: checks the reads of resources that are written by passes with frame slices. A repeat with
// `perFrame` divides its passes into frame slices, and each of these passes runs only in some frames. In
// every frame, each read must see the version that its declaration names, with any combination of slices.
// Culled passes count as writers, too. Example: pass A writes an image in every frame, and pass B overwrites
// it in some frames. In the other frames the image has A's content, so the compiler must not cull A.
// Error C331: a barrier discards content that is still needed. Error C332: a read sees the wrong version, or
// content is lost between frames.
#pragma once

#include "check/faults/fault_list.h"
#include "weft/plan.h"

namespace weft::check {

void check_frame_slices(const FramePlan& plan, FaultList& faults);

}  // namespace weft::check
