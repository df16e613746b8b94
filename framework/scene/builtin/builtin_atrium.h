// Purpose: "atrium", the default scene: a court with an arcade around it. It is generated without any file.
// Its light is the daylight or moonlight at `hour`, from 0 to 24.
#pragma once

#include "weft/scene/scene.h"

namespace weft::scene {

[[nodiscard]] Scene make_atrium(float hour);

}  // namespace weft::scene
