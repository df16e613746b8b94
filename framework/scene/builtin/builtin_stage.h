// Purpose: "stage", a film set with four kinds of shaped light: a spot with a projected picture, a rectangle
// with barn doors, two tubes, and a lantern with holes on all sides and a custom falloff.
#pragma once

#include "weft/scene/scene.h"

namespace weft::scene {

[[nodiscard]] Scene make_stage();

}  // namespace weft::scene
