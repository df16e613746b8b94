// Purpose: the default scene, "atrium", made from nothing but numbers, as it looks at an hour of its day.
#pragma once

#include "weft/scene/scene.h"

namespace weft::scene {

[[nodiscard]] Scene make_atrium(float hour);

}  // namespace weft::scene
