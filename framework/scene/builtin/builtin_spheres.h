// Purpose: "spheres", a 7 × 7 grid on a ground: roughness grows to the right, metalness to the back. One
// light, no
//   textures, so that every pixel can be computed a second time in a test.
#pragma once

#include "weft/scene/scene.h"

namespace weft::scene {

[[nodiscard]] Scene make_spheres();

}  // namespace weft::scene
