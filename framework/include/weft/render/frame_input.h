// Purpose: the values that a program may change from frame to frame. Parameters of the graph are not among
// them: to change a parameter, swap the plan (Session::prepare()). Units: seconds; exposure in EV (radiance
// is stored multiplied by 2^EV).
#pragma once

#include "weft/scene/scene.h"

namespace weft::render {

struct FrameInput {
    scene::Camera camera;
    float exposure_ev = 0;
    double time_s = 0;
    double delta_time_s = 0;  // Time since the previous frame.
};

}  // namespace weft::render
