// Purpose: values that may change from frame to frame. Parameters are values of the plan, so changing one is
// a swap (Session::prepare()). Units: seconds; exposure in EV (hdr is stored × 2^EV).
#pragma once

#include "weft/scene/scene.h"

namespace weft::render {

struct FrameInput {
    scene::Camera camera;
    float exposure_ev = 0;
    double time_s = 0;
    double delta_time_s = 0;  // since the previous frame
};

}  // namespace weft::render
