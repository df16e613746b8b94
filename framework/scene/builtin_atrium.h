// Purpose: the default scene, "atrium", made from nothing but numbers.
#pragma once

#include "scene/scene.h"

namespace weft::scene {

[[nodiscard]] Scene make_atrium();

}  // namespace weft::scene
