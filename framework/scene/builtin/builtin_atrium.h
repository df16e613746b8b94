// Purpose: the default scene, "atrium", generated without any file, with the light of a chosen hour of the
// day.
#pragma once

#include "weft/scene/scene.h"

namespace weft::scene {

[[nodiscard]] Scene make_atrium(float hour);

}  // namespace weft::scene
