// Purpose: the values of FrameInput::parameters that a frame uses directly: switches and scales of live
// sizes. Other parameters change values of the plan (RunningGraph::set_parameters()).
#pragma once

#include <map>
#include <string>

#include "weft/live_value.h"

namespace weft::render {

// The last values that the program has given to the running graph, by the name of the parameter.
struct LiveInputs {
    std::map<std::string, bool, std::less<>> switches;
    Scales scales;
};

}  // namespace weft::render
