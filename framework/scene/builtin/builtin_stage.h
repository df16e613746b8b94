// Purpose: "stage", a set under four kinds of lamps with what shapes them: a spot with a picture, a rectangle
// with barn doors, two tubes, and a lantern with holes all around and a falloff of its own.
#pragma once

#include "weft/scene/scene.h"

namespace weft::scene {

[[nodiscard]] Scene make_stage();

}  // namespace weft::scene
