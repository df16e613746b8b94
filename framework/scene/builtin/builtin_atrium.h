// Purpose: "atrium", the default scene: a court with an arcade around it. It is generated without any file
// and lit as at a chosen hour of the day.
#pragma once

#include "weft/scene/scene.h"

namespace weft::scene {

[[nodiscard]] Scene make_atrium(float hour);

}  // namespace weft::scene
