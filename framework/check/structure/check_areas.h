// Purpose: checks the numbers of a plan that follow live scales, which are factors of image sizes that may
// change in each frame. At scale 1, the area of each image is its extent, and each pass has the numbers of
// workgroups and the rectangles that the plan states. All attachments of a pass have the same area, and so do
// the source and the target of a copy. Fault: C351.
#pragma once

#include "check/faults/fault_list.h"

namespace weft::check {

void check_areas(const FramePlan& plan, FaultList& faults);

}  // namespace weft::check
